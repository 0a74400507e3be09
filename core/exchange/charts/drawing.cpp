#include "core/exchange/charts/drawing.h"

#include <opencv2/imgproc.hpp>

#include <sstream>

namespace esm {

namespace {

constexpr double fontScale = 0.4; ///< of the font that is 22 pixels high
constexpr int subpixelBits = 4;

std::string colourText(const Drawing::Colour& colour) {
    std::ostringstream text;
    text << "rgb(" << colour[0] << ',' << colour[1] << ',' << colour[2] << ')';
    return text.str();
}

const char* svgAnchor(Drawing::Anchor anchor) {
    switch (anchor) {
    case Drawing::Anchor::Middle:
        return "middle";
    case Drawing::Anchor::End:
        return "end";
    default:
        return "start";
    }
}

std::string escaped(const std::string& words) {
    std::string text;
    for (const char c : words)
        text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return text;
}

cv::Scalar pixelColour(const Drawing::Colour& colour) {
    return {double(colour[0]), double(colour[1]), double(colour[2]), 255};
}

cv::Point subpixels(const Drawing::Place& place) {
    constexpr double unit = 1 << subpixelBits;
    return {cvRound(place.x * unit), cvRound(place.y * unit)};
}

void put(const Drawing::Label& label, cv::Mat& pixels) {
    const cv::Size size = cv::getTextSize(label.text, cv::FONT_HERSHEY_SIMPLEX, fontScale, 1, nullptr);
    const double part = label.anchor == Drawing::Anchor::Start ? 0
                        : label.anchor == Drawing::Anchor::End ? 1
                                                               : 0.5;
    const cv::Point start(cvRound(label.place.x - part * size.width), cvRound(label.place.y));
    cv::putText(pixels, label.text, start, cv::FONT_HERSHEY_SIMPLEX, fontScale, {0, 0, 0, 255}, 1,
                cv::LINE_AA);
}

} // namespace

std::string toSvg(const Drawing& drawing) {
    std::ostringstream text;
    text << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << drawing.width << "\" height=\""
         << drawing.height << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
         << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (const auto& [from, to, colour, width] : drawing.lines)
        text << "<line x1=\"" << from.x << "\" y1=\"" << from.y << "\" x2=\"" << to.x << "\" y2=\"" << to.y
             << "\" stroke=\"" << colourText(colour) << "\" stroke-width=\"" << width << "\"/>\n";
    for (const auto& [centre, radius, colour, filled] : drawing.dots)
        text << "<circle cx=\"" << centre.x << "\" cy=\"" << centre.y << "\" r=\"" << radius << "\" fill=\""
             << (filled ? colourText(colour) : "none") << "\" stroke=\"" << colourText(colour) << "\"/>\n";
    for (const auto& [place, words, anchor] : drawing.labels)
        text << "<text x=\"" << place.x << "\" y=\"" << place.y << "\" text-anchor=\"" << svgAnchor(anchor)
             << "\">" << escaped(words) << "</text>\n";
    text << "</svg>\n";
    return text.str();
}

Image toImage(const Drawing& drawing) {
    Image image;
    image.width = drawing.width;
    image.height = drawing.height;
    image.pixels.assign(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                        255);
    cv::Mat pixels(image.height, image.width, CV_8UC4, image.pixels.data());
    for (const auto& [from, to, colour, width] : drawing.lines)
        cv::line(pixels, subpixels(from), subpixels(to), pixelColour(colour), width, cv::LINE_AA,
                 subpixelBits);
    for (const auto& [centre, radius, colour, filled] : drawing.dots)
        cv::circle(pixels, subpixels(centre), cvRound(radius * (1 << subpixelBits)), pixelColour(colour),
                   filled ? cv::FILLED : 1, cv::LINE_AA, subpixelBits);
    for (const Drawing::Label& label : drawing.labels)
        put(label, pixels);
    return image;
}

} // namespace esm
