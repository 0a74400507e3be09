#include "core/texture/photo/colour_match.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>
#include <vector>

namespace esm {

namespace {

/// Colours are matched in CIE L*a*b* and not in red, green and blue: these three go up and down together with
/// the light, so that each alone stretched to another spread would tint the shadows. Lightness and the two
/// colour axes are nearly independent in photos, which is what lets one match them one by one (Reinhard et
/// al. use the space lαβ for that; L*a*b* is the common one).
using Lab = cv::Mat; ///< a row of CIE L*a*b*, three floats a pixel

/// A row at a time, as the whole photo in floats would take three times its size.
Lab labRow(const Image& image, int y) {
    cv::Mat row(1, image.width, CV_32FC3);
    for (int x = 0; x < image.width; ++x)
        for (int channel = 0; channel < 3; ++channel)
            row.at<cv::Vec3f>(0, x)[channel] = static_cast<float>(image.at(x, y)[channel]) / 255;
    cv::cvtColor(row, row, cv::COLOR_RGB2Lab);
    return row;
}

std::uint8_t brightestChannel(const std::uint8_t* pixel) {
    return std::max({pixel[0], pixel[1], pixel[2]});
}

/// The brightest channel of every pixel, without the noise of the camera: the median of what lies around it,
/// which leaves the border of a field where it is.
cv::Mat1b calmBrightness(const Image& photo) {
    constexpr double shareOfDiagonal = 0.004;
    cv::Mat1b brightness(photo.height, photo.width);
    tbb::parallel_for(0, photo.height, [&](int y) {
        for (int x = 0; x < photo.width; ++x)
            brightness(y, x) = brightestChannel(photo.at(x, y));
    });
    const double reach = shareOfDiagonal * std::hypot(photo.width, photo.height);
    cv::medianBlur(brightness, brightness, 2 * std::max(1, static_cast<int>(std::lround(reach))) + 1);
    return brightness;
}

/// 0 up to one brightness, 1 from the other, and smooth between them.
double rise(std::uint8_t brightness, double from, double to) {
    return std::clamp((brightness - from) / (to - from), 0.0, 1.0);
}

/// How much of a pixel is tissue: 0 where its surroundings are nearly black, as a field's outside and hollows
/// that show no colour are, 1 from where colours can be told. Single pixels are not asked, as their noise in
/// a dark photo goes all the way from the one to the other, but for whether they are black themselves.
double tissueShare(const std::uint8_t* pixel, std::uint8_t around) {
    return std::min(rise(around, 20, 40), rise(brightestChannel(pixel), 12, 20));
}

/// Weighted sums from which means and spreads follow. Rows are summed by themselves and added up in their
/// order: the same to the last bit with any number of threads.
struct ColourSums {
    double weight = 0;
    std::array<double, 3> sum{}, squares{};

    void add(const cv::Vec3f& lab, double share) {
        weight += share;
        for (std::size_t i = 0; i < 3; ++i) {
            const double value = lab[static_cast<int>(i)];
            sum[i] += share * value;
            squares[i] += share * value * value;
        }
    }
    void add(const ColourSums& other) {
        weight += other.weight;
        for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += other.sum[i];
            squares[i] += other.squares[i];
        }
    }
    double mean(std::size_t i) const { return sum[i] / weight; }
    double spread(std::size_t i) const {
        return std::sqrt(std::max(0.0, squares[i] / weight - mean(i) * mean(i)));
    }
};

/// Both, over what is seen of both in one row.
std::array<ColourSums, 2> sumsOfRow(const Image& photo, const Image& beneath, const cv::Mat1b& brightness,
                                    int y) {
    const Lab above = labRow(photo, y), below = labRow(beneath, y);
    std::array<ColourSums, 2> sums;
    for (int x = 0; x < photo.width; ++x) {
        const double share = tissueShare(photo.at(x, y), brightness(y, x)) * photo.at(x, y)[3] *
                             beneath.at(x, y)[3] / (255.0 * 255.0);
        if (!(share > 0)) continue;
        sums[0].add(above.at<cv::Vec3f>(0, x), share);
        sums[1].add(below.at<cv::Vec3f>(0, x), share);
    }
    return sums;
}

} // namespace

/// (value − mean) · spread ratio + mean beneath, written as one product and one sum. The ratio is held
/// between 0.5 and 2, as a photo of even tissue over varied tissue would have its noise stretched to the
/// spread of what lies beneath. With no spread in either there is no ratio, and only the means are matched.
std::optional<ColourMatch> matchColours(const Image& photo, const Image& beneath) {
    constexpr double fewestPixels = 100, flat = 0.5; // a spread below which there is nothing to scale
    if (photo.empty() || photo.width != beneath.width || photo.height != beneath.height) return std::nullopt;
    const cv::Mat1b brightness = calmBrightness(photo);
    std::vector<std::array<ColourSums, 2>> rows(static_cast<std::size_t>(photo.height));
    tbb::parallel_for(0, photo.height, [&](int y) {
        rows[static_cast<std::size_t>(y)] = sumsOfRow(photo, beneath, brightness, y);
    });
    std::array<ColourSums, 2> sums;
    for (const auto& row : rows)
        for (std::size_t picture = 0; picture < 2; ++picture)
            sums[picture].add(row[picture]);
    const auto& [from, to] = sums;
    if (from.weight < fewestPixels) return std::nullopt;
    ColourMatch match;
    for (std::size_t i = 0; i < 3; ++i) {
        if (from.spread(i) > flat && to.spread(i) > flat)
            match.scale[i] = std::clamp(to.spread(i) / from.spread(i), smallestSpread, largestSpread);
        match.offset[i] = to.mean(i) - match.scale[i] * from.mean(i);
    }
    return match;
}

void applyMatch(Image& photo, const ColourMatch& match) {
    const cv::Scalar scale(match.scale[0], match.scale[1], match.scale[2]);
    const cv::Scalar offset(match.offset[0], match.offset[1], match.offset[2]);
    const cv::Mat1b brightness = calmBrightness(photo);
    tbb::parallel_for(0, photo.height, [&](int y) {
        Lab row = labRow(photo, y);
        cv::multiply(row, scale, row);
        cv::add(row, offset, row);
        cv::cvtColor(row, row, cv::COLOR_Lab2RGB);
        for (int x = 0; x < photo.width; ++x) {
            std::uint8_t* pixel = photo.at(x, y);
            const double share = pixel[3] > 0 ? tissueShare(pixel, brightness(y, x)) : 0;
            for (int channel = 0; channel < 3; ++channel) {
                const double matched = 255 * std::clamp(row.at<cv::Vec3f>(0, x)[channel], 0.0F, 1.0F);
                pixel[channel] = static_cast<std::uint8_t>(
                    std::lround(pixel[channel] + share * (matched - pixel[channel])));
            }
        }
    });
}

} // namespace esm
