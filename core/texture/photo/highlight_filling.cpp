#include "core/texture/photo/highlights.h"

#include "core/support/parallel_steps.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/photo.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace esm {

namespace {

constexpr double inpaintRadius = 4; ///< pixels around each that is filled, whose colours are mixed
/// Around a highlight, in which its surroundings are looked for: three times that.
constexpr int surroundingPixels = 12;
constexpr int darkestSource = 32; ///< brightest channel; what is darker is no tissue to fill from

bool isOpaque(const std::uint8_t* pixel) {
    return pixel[3] > 0;
}

int strongestOf(const std::uint8_t* pixel) {
    return std::max({pixel[0], pixel[1], pixel[2]});
}

/// The least and the greatest share that a channel has of the brightest one, of nine tenths of the pixels
/// that are usable.
std::pair<float, float> usualShares(const cv::Mat& colours, const cv::Mat& unusable, int channel) {
    std::vector<float> shares;
    for (int y = 0; y < colours.rows; ++y)
        for (int x = 0; x < colours.cols; ++x) {
            const std::uint8_t* pixel = colours.ptr<std::uint8_t>(y, x);
            if (unusable.at<std::uint8_t>(y, x) == 0 && strongestOf(pixel) > 0)
                shares.push_back(static_cast<float>(pixel[channel]) / static_cast<float>(strongestOf(pixel)));
        }
    if (shares.empty()) return {0.0F, 1.0F};
    const auto rare = static_cast<std::ptrdiff_t>(shares.size() / 20);
    const auto least = shares.begin() + rare, most = shares.end() - 1 - rare;
    std::nth_element(shares.begin(), least, shares.end());
    const float low = *least;
    std::nth_element(shares.begin(), most, shares.end());
    return {low, *most};
}

/// Keeps what was filled within the usual hues of what it was filled from. Filling goes on with the slope of
/// colours at the rim: where a lens left the faintest lilac there, it ends in magenta.
void keepHues(cv::Mat& filled, const cv::Mat& unusable) {
    std::array<std::pair<float, float>, 3> usual;
    for (int channel = 0; channel < 3; ++channel)
        usual[static_cast<std::size_t>(channel)] = usualShares(filled, unusable, channel);
    for (int y = 0; y < filled.rows; ++y)
        for (int x = 0; x < filled.cols; ++x) {
            if (unusable.at<std::uint8_t>(y, x) == 0) continue;
            std::uint8_t* pixel = filled.ptr<std::uint8_t>(y, x);
            const auto brightest = static_cast<float>(strongestOf(pixel));
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const auto [least, most] = usual[channel];
                const float kept =
                    std::clamp(static_cast<float>(pixel[channel]), least * brightest, most * brightest);
                pixel[channel] = static_cast<std::uint8_t>(std::lround(kept));
            }
        }
}

/// The part of a photo around a highlight and which of its pixels a highlight must not be filled from, at
/// best and at any rate. What is nearly black is the outside of a field or a hollow: filled from there a
/// highlight at the rim would become a dark hole.
struct Surroundings {
    cv::Mat colours, noTissue, nothing;

    /// The part filled, or an empty picture where there is nothing to fill it from.
    cv::Mat filled() const {
        for (const cv::Mat& unusable : {noTissue, nothing}) {
            if (cv::countNonZero(unusable) == static_cast<int>(unusable.total())) continue;
            cv::Mat result;
            cv::inpaint(colours, unusable, result, inpaintRadius, cv::INPAINT_TELEA);
            keepHues(result, unusable);
            return result;
        }
        return {};
    }
};

/// What the mask has is not read: other highlights are filled meanwhile.
Surroundings surroundingsIn(const cv::Rect& part, const Image& photo, const cv::Mat& mask) {
    Surroundings around{cv::Mat(part.size(), CV_8UC3, cv::Scalar()), mask(part).clone(), mask(part).clone()};
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            if (around.nothing.at<std::uint8_t>(y, x) > 0) continue;
            const std::uint8_t* p = photo.at(part.x + x, part.y + y);
            std::copy_n(p, 3, around.colours.ptr<std::uint8_t>(y, x));
            if (!isOpaque(p)) around.nothing.at<std::uint8_t>(y, x) = 255;
            if (!isOpaque(p) || std::max({p[0], p[1], p[2]}) < darkestSource)
                around.noTissue.at<std::uint8_t>(y, x) = 255;
        }
    return around;
}

/// A highlight by one of its pixels, and what surrounds it.
struct Highlight {
    cv::Point pixel;
    cv::Rect part;
};

/// Found by their outlines: a number for every pixel would take four times the memory of the mask.
std::vector<Highlight> outlinedHighlights(const cv::Mat& mask) {
    std::vector<std::vector<cv::Point>> outlines;
    std::vector<cv::Vec4i> nesting;
    cv::findContours(mask, outlines, nesting, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE);
    std::vector<Highlight> highlights;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        constexpr int parent = 3;
        if (nesting[i][parent] >= 0) continue; // the rim of a hole
        const cv::Rect box = cv::boundingRect(outlines[i]);
        const cv::Rect part(box.x - surroundingPixels, box.y - surroundingPixels,
                            box.width + 2 * surroundingPixels, box.height + 2 * surroundingPixels);
        highlights.push_back({outlines[i].front(), part & cv::Rect({}, mask.size())});
    }
    return highlights;
}

/// @returns pixels filled
std::size_t fillOne(Image& photo, const cv::Mat& mask, const Highlight& highlight) {
    const cv::Rect& part = highlight.part;
    const cv::Mat result = surroundingsIn(part, photo, mask).filled();
    if (result.empty()) return 0;
    cv::Mat numbers;
    cv::connectedComponents(mask(part), numbers);
    const int own = numbers.at<int>(highlight.pixel - part.tl());
    std::size_t filled = 0;
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            if (numbers.at<int>(y, x) != own) continue;
            std::copy_n(result.ptr<std::uint8_t>(y, x), 3, photo.at(part.x + x, part.y + y));
            ++filled;
        }
    return filled;
}

} // namespace

/// By fast marching (Telea 2004), from the rim inwards, each pixel from those around it that are known
/// already: the tissue's colours go on into the highlight. A mean of the rim alone would leave a flat spot.
std::size_t fillHighlights(Image& photo, const PixelMask& shines, const Progress& progress) {
    if (photo.empty()) return 0;
    const cv::Mat mask(photo.height, photo.width, CV_8U, const_cast<std::uint8_t*>(shines.data()));
    const std::vector<Highlight> highlights = outlinedHighlights(mask);
    std::vector<std::size_t> filled(highlights.size(), 0);
    // One by one, so that the cost goes with what is filled; they do not touch each other.
    forEachInParallel(highlights.size(), progress,
                      [&](std::size_t i) { filled[i] = fillOne(photo, mask, highlights[i]); });
    return std::accumulate(filled.begin(), filled.end(), std::size_t{0});
}

} // namespace esm
