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

/// How much of a pixel is tissue, by its brightness: 0 where it is nearly black, as a field's outside and
/// hollows that show no colour are, 1 from where colours can be told, and smooth between them.
double tissueShare(const std::uint8_t* pixel) {
    constexpr double black = 20, lit = 40; // brightest channel
    const double brightest = std::max({pixel[0], pixel[1], pixel[2]});
    return std::clamp((brightest - black) / (lit - black), 0.0, 1.0);
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
std::array<ColourSums, 2> sumsOfRow(const Image& photo, const Image& beneath, int y) {
    const Lab above = labRow(photo, y), below = labRow(beneath, y);
    std::array<ColourSums, 2> sums;
    for (int x = 0; x < photo.width; ++x) {
        const double share =
            tissueShare(photo.at(x, y)) * photo.at(x, y)[3] * beneath.at(x, y)[3] / (255.0 * 255.0);
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
    std::vector<std::array<ColourSums, 2>> rows(static_cast<std::size_t>(photo.height));
    tbb::parallel_for(0, photo.height,
                      [&](int y) { rows[static_cast<std::size_t>(y)] = sumsOfRow(photo, beneath, y); });
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
    tbb::parallel_for(0, photo.height, [&](int y) {
        Lab row = labRow(photo, y);
        cv::multiply(row, scale, row);
        cv::add(row, offset, row);
        cv::cvtColor(row, row, cv::COLOR_Lab2RGB);
        for (int x = 0; x < photo.width; ++x) {
            std::uint8_t* pixel = photo.at(x, y);
            const double share = pixel[3] > 0 ? tissueShare(pixel) : 0;
            for (int channel = 0; channel < 3; ++channel) {
                const double matched = 255 * std::clamp(row.at<cv::Vec3f>(0, x)[channel], 0.0F, 1.0F);
                pixel[channel] = static_cast<std::uint8_t>(
                    std::lround(pixel[channel] + share * (matched - pixel[channel])));
            }
        }
    });
}

} // namespace esm
