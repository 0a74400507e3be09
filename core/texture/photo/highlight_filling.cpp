#include "core/texture/photo/highlights.h"

#include "core/texture/parallel_steps.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/photo.hpp>

#include <algorithm>
#include <numeric>
#include <tbb/parallel_for.h>
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

/// 255 where the photo's pixel `is` so, else 0.
template<typename Is> cv::Mat maskOf(const Image& photo, const Is& is) {
    cv::Mat mask(photo.height, photo.width, CV_8U);
    tbb::parallel_for(0, photo.height, [&](int y) {
        for (int x = 0; x < photo.width; ++x)
            mask.at<std::uint8_t>(y, x) = is(photo.at(x, y)) ? 255 : 0;
    });
    return mask;
}

/// The photo and which of its pixels a highlight must not be filled from, at best and at any rate. What is
/// nearly black is the outside of a field or a hollow: filled from there a highlight at the rim would become
/// a dark hole.
struct Surroundings {
    cv::Mat colours, noTissue, nothing;

    /// The part of the photo filled, or an empty picture where there is nothing to fill it from.
    cv::Mat filled(const cv::Rect& part) const {
        for (const cv::Mat& unusable : {noTissue, nothing}) {
            if (cv::countNonZero(unusable(part)) == part.area()) continue;
            cv::Mat result;
            cv::inpaint(colours(part), unusable(part), result, inpaintRadius, cv::INPAINT_TELEA);
            return result;
        }
        return {};
    }
};

Surroundings surroundingsOf(const Image& photo, const cv::Mat& mask) {
    Surroundings around;
    around.noTissue = mask | maskOf(photo, [](const std::uint8_t* p) {
                          return !isOpaque(p) || std::max({p[0], p[1], p[2]}) < darkestSource;
                      });
    around.nothing = mask | maskOf(photo, [](const std::uint8_t* p) { return !isOpaque(p); });
    const cv::Mat all(photo.height, photo.width, CV_8UC4, const_cast<std::uint8_t*>(photo.pixels.data()));
    cv::cvtColor(all, around.colours, cv::COLOR_RGBA2RGB);
    return around;
}

cv::Rect partAround(const cv::Mat& boxes, int highlight, const cv::Size& size) {
    const int* box = boxes.ptr<int>(highlight);
    return cv::Rect(box[cv::CC_STAT_LEFT] - surroundingPixels, box[cv::CC_STAT_TOP] - surroundingPixels,
                    box[cv::CC_STAT_WIDTH] + 2 * surroundingPixels,
                    box[cv::CC_STAT_HEIGHT] + 2 * surroundingPixels) &
           cv::Rect({}, size);
}

} // namespace

/// By fast marching (Telea 2004), from the rim inwards, each pixel from those around it that are known
/// already: the tissue's colours go on into the highlight. A mean of the rim alone would leave a flat spot.
std::size_t fillHighlights(Image& photo, const PixelMask& shines, const Progress& progress) {
    if (photo.empty()) return 0;
    const cv::Mat mask(photo.height, photo.width, CV_8U, const_cast<std::uint8_t*>(shines.data()));
    cv::Mat labels, boxes, middles;
    const int count = cv::connectedComponentsWithStats(mask, labels, boxes, middles);
    if (count <= 1) return 0;
    const Surroundings around = surroundingsOf(photo, mask);
    std::vector<std::size_t> filled(static_cast<std::size_t>(count), 0);
    // One by one, so that the cost goes with what is filled; they do not touch each other.
    forEachInParallel(static_cast<std::size_t>(count - 1), progress, [&](std::size_t before) {
        const int highlight = static_cast<int>(before) + 1;
        const cv::Rect part = partAround(boxes, highlight, mask.size());
        const cv::Mat result = around.filled(part);
        if (result.empty()) return;
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) {
                if (labels.at<int>(part.y + y, part.x + x) != highlight) continue;
                std::copy_n(result.ptr<std::uint8_t>(y, x), 3, photo.at(part.x + x, part.y + y));
                ++filled[static_cast<std::size_t>(highlight)];
            }
    });
    return std::accumulate(filled.begin(), filled.end(), std::size_t{0});
}

} // namespace esm
