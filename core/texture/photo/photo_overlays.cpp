#include "core/texture/photo/photo_overlays.h"

#include "core/texture/photo/mask_outlines.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

cv::Mat pixelsOf(const Image& photo) {
    return {photo.height, photo.width, CV_8UC4, const_cast<std::uint8_t*>(photo.pixels.data())};
}

cv::Mat roundElement(int width) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width});
}

/// What may be a letter: one connected stroke of ink.
struct Letter {
    cv::Rect box;
    double left() const { return box.x; }
    double right() const { return box.x + box.width; }
    double middle() const { return box.y + box.height / 2.0; }
};

/// Letters are thin and much brighter than what they stand on. In the green channel, in which tissue is dark
/// and both white and yellow are bright.
cv::Mat inkOf(const cv::Mat& green, int thickest) {
    constexpr double contrast = 38;
    cv::Mat opened;
    cv::morphologyEx(green, opened, cv::MORPH_OPEN, roundElement(thickest));
    return green - opened > contrast;
}

/// A letter is as high as letters are in a picture of that size, and its strokes leave much of its box empty,
/// which a fleck, round and full, does not.
std::vector<Letter> lettersIn(const cv::Mat& ink) {
    const int lowest = 6, highest = std::max(14, ink.rows / 14);
    cv::Mat labels, boxes, middles;
    const int count = cv::connectedComponentsWithStats(ink, labels, boxes, middles);
    std::vector<Letter> letters;
    letters.reserve(static_cast<std::size_t>(count));
    for (int label = 1; label < count; ++label) {
        const int* box = boxes.ptr<int>(label);
        const int width = box[cv::CC_STAT_WIDTH], height = box[cv::CC_STAT_HEIGHT];
        const double full = box[cv::CC_STAT_AREA] / static_cast<double>(width * height);
        const bool isBar = 3 * width <= height; // as of 1, I or a slash that stands
        if (height >= lowest && height <= highest && width <= 4 * height && full > 0.1 &&
            (full < 0.72 || isBar))
            letters.push_back({{box[cv::CC_STAT_LEFT], box[cv::CC_STAT_TOP], width, height}});
    }
    return letters;
}

bool standBeside(const Letter& a, const Letter& b) {
    const double higher = std::max(a.box.height, b.box.height), lower = std::min(a.box.height, b.box.height);
    const double gap = std::max(a.left(), b.left()) - std::min(a.right(), b.right());
    return higher <= 1.5 * lower && gap < 1.5 * higher && std::abs(a.middle() - b.middle()) < 0.25 * higher;
}

/// Letters that stand beside each other, as lists of places in `letters`.
std::vector<std::vector<std::size_t>> linesOf(const std::vector<Letter>& letters) {
    std::vector<std::vector<std::size_t>> lines;
    std::vector<bool> isTaken(letters.size(), false);
    for (std::size_t first = 0; first < letters.size(); ++first) {
        if (isTaken[first]) continue;
        isTaken[first] = true;
        std::vector<std::size_t> line{first};
        for (std::size_t at = 0; at < line.size(); ++at)
            for (std::size_t other = 0; other < letters.size(); ++other)
                if (!isTaken[other] && standBeside(letters[line[at]], letters[other])) {
                    isTaken[other] = true;
                    line.push_back(other);
                }
        lines.push_back(std::move(line));
    }
    return lines;
}

/// Three letters of one height on one line are text; a wet fold's flecks differ in height and place.
/// Points, colons and what runs together with tissue lie within reach of the box around them.
void coverText(const cv::Mat& ink, cv::Mat& mask) {
    const std::vector<Letter> letters = lettersIn(ink);
    for (const std::vector<std::size_t>& line : linesOf(letters)) {
        if (line.size() < 3) continue;
        cv::Rect box = letters[line.front()].box;
        int highest = 0;
        for (const std::size_t letter : line) {
            box |= letters[letter].box;
            highest = std::max(highest, letters[letter].box.height);
        }
        const int aside = std::max(2, highest * 3 / 4), above = std::max(2, highest / 4);
        box = cv::Rect(box.x - aside, box.y - above, box.width + 2 * aside, box.height + 2 * above);
        mask(box & cv::Rect({}, mask.size())).setTo(255);
    }
}

/// Where a camera shows no such thing: tissue has noise, and a box a colour of none or one even grey.
cv::Mat boxColours(const cv::Mat& colours) {
    cv::Mat least, most, is(colours.size(), CV_8U);
    cv::erode(colours, least, cv::Mat::ones(5, 5, CV_8U));
    cv::dilate(colours, most, cv::Mat::ones(5, 5, CV_8U));
    for (int y = 0; y < colours.rows; ++y)
        for (int x = 0; x < colours.cols; ++x) {
            const auto &c = colours.at<cv::Vec3b>(y, x), &low = least.at<cv::Vec3b>(y, x),
                       &high = most.at<cv::Vec3b>(y, x);
            const bool isEven = high[0] - low[0] <= 2 && high[1] - low[1] <= 2 && high[2] - low[2] <= 2;
            const bool isGrey =
                std::abs(c[0] - c[1]) < 8 && std::abs(c[2] - c[1]) < 8 && c[1] > 50 && c[1] < 240;
            is.at<std::uint8_t>(y, x) = isNoTissue(c.val) || (isEven && isGrey) ? 255 : 0;
        }
    return is;
}

/// Boxes fill most of the rectangle around them, with what is written in them filled in.
void coverBoxes(const cv::Mat& colours, cv::Mat& mask) {
    constexpr int blurred = 10; // JPEG stores colours by blocks of 16 pixels, which blur a box's rim
    cv::Mat is = boxColours(colours);
    cv::morphologyEx(is, is, cv::MORPH_CLOSE, cv::Mat::ones(7, 7, CV_8U));
    cv::morphologyEx(is, is, cv::MORPH_OPEN, cv::Mat::ones(7, 7, CV_8U));
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(is, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    for (const auto& outline : outlines) {
        const cv::Rect box = cv::boundingRect(outline);
        if (box.area() < 150 || cv::contourArea(outline) < 0.6 * box.area()) continue;
        const cv::Rect wider(box.x - blurred, box.y - blurred, box.width + 2 * blurred,
                             box.height + 2 * blurred);
        mask(wider & cv::Rect({}, mask.size())).setTo(255);
    }
}

} // namespace

bool isNoTissue(const std::uint8_t* pixel) {
    const int most = std::max(pixel[1], pixel[2]);
    return most > 60 && 5 * pixel[0] < 2 * most;
}

/// No recogniser of letters is asked: what they say does not matter, and they are told by their shape.
/// Strokes of ink are found by a top hat, as bright things thinner than a few pixels, and taken for text
/// where they stand in a line; boxes by colours that tissue does not have.
std::vector<PhotoStroke> findOverlays(const Image& photo) {
    if (photo.empty()) return {};
    cv::Mat colours, alpha;
    cv::cvtColor(pixelsOf(photo), colours, cv::COLOR_RGBA2RGB);
    cv::extractChannel(pixelsOf(photo), alpha, 3);
    cv::Mat green, mask = cv::Mat::zeros(colours.size(), CV_8U);
    cv::extractChannel(colours, green, 1);
    coverText(inkOf(green, std::max(5, photo.height / 100 * 2 + 1)), mask);
    coverBoxes(colours, mask);
    mask.setTo(0, alpha == 0);
    return strokesAround(mask, 0.7, false);
}

} // namespace esm
