#include "core/texture/layers/multi_band.h"

#include "core/support/parallel_steps.h"
#include "core/texture/photo/bilinear.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>
#include <vector>

namespace esm {

namespace {

constexpr int longestSide = 1024;   ///< pixels
constexpr float borderPerPixel = 4; ///< of a band's own pixels, over which it fades
constexpr int smallestLevel = 4;    ///< pixels, of the coarsest band's shorter side

/// The photo in a smaller size, red, green, blue 0 to 255 and alpha 0 to 1. Read from the level of its
/// pyramid that has pixels of that size, so that nothing finer is taken for a coarse difference.
cv::Mat reduced(const PhotoSampler& sampler, const cv::Size& size) {
    cv::Mat picture(size, CV_32FC4);
    const double perColumn = static_cast<double>(sampler.width()) / size.width;
    const double perRow = static_cast<double>(sampler.height()) / size.height;
    const double depth = std::log2(std::max(perColumn, perRow));
    tbb::parallel_for(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            const Eigen::Vector4f colour = sampler.at((x + 0.5) * perColumn, (y + 0.5) * perRow, depth);
            picture.at<cv::Vec4f>(y, x) = {colour.x(), colour.y(), colour.z(), colour.w()};
        }
    });
    return picture;
}

/// The photo's alpha × the mask, where it meets surface.
void erase(cv::Mat& photo, const Image& mask) {
    for (int y = 0; y < photo.rows; ++y)
        for (int x = 0; x < photo.cols; ++x)
            if (mask.at(x, y)[3] > 0)
                photo.at<cv::Vec4f>(y, x)[3] *= static_cast<float>(mask.at(x, y)[0]) / 255;
}

/// What lies beneath less the photo; 0 where either is not known.
cv::Mat differenceFrom(const cv::Mat& photo, const Image& beneath) {
    cv::Mat difference(photo.size(), CV_32FC3, cv::Scalar::all(0));
    for (int y = 0; y < photo.rows; ++y) {
        for (int x = 0; x < photo.cols; ++x) {
            const std::uint8_t* under = beneath.at(x, y);
            const auto& over = photo.at<cv::Vec4f>(y, x);
            if (under[3] == 0 || !(over[3] > 0)) continue;
            for (int channel = 0; channel < 3; ++channel)
                difference.at<cv::Vec3f>(y, x)[channel] = static_cast<float>(under[channel]) - over[channel];
        }
    }
    return difference;
}

/// Pixels from the border of what a photo shows, below 0 outside. A row of pixels outside is put around it,
/// so that the photo's own sides are a border too. The exact distance, as a chamfer's octagons would show in
/// a wide soft border.
cv::Mat depthInside(const cv::Mat& photo) {
    cv::Mat shown(photo.rows + 2, photo.cols + 2, CV_8U, cv::Scalar(0)), distance;
    for (int y = 0; y < photo.rows; ++y)
        for (int x = 0; x < photo.cols; ++x)
            shown.at<std::uint8_t>(y + 1, x + 1) = photo.at<cv::Vec4f>(y, x)[3] > 0 ? 255 : 0;
    cv::distanceTransform(shown, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    return distance({1, 1, photo.cols, photo.rows}) - 0.5; // from a centre, of which the next lies outside
}

/// How many times the difference is halved until its pixels fade over `widest` pixels. Fewer and a step of
/// brightness is left to fade too soon; the coarsest level keeps four pixels across, below which it would be
/// hardly more than one mean of all.
int coarsestLevel(const cv::Size& size, double widest) {
    int level = 0;
    while (borderPerPixel * std::ldexp(1.0, level + 1) <= widest &&
           std::min(size.width, size.height) >> (level + 1) >= smallestLevel)
        ++level;
    return level;
}

/// A picture of a coarser level in the size of the finest.
cv::Mat widened(cv::Mat picture, const std::vector<cv::Size>& sizes, std::size_t level) {
    while (level > 0) {
        cv::Mat wider;
        cv::pyrUp(picture, wider, sizes[--level]);
        picture = wider;
    }
    return picture;
}

/// The share of a band that is left out of the photo: all at the border, where depth is 0.
float leftOut(float depth, float border) {
    const float t = std::clamp(depth / border, 0.0F, 1.0F);
    return 1 - t * t * (3 - 2 * t);
}

/// Blending both pictures in bands, as Burt and Adelson do, would take what lies beneath into the photo with
/// all its details and lose those of the photo. As Laplacian pyramids are linear, the blend is the photo + Σ
/// bands of (beneath − photo), each times the share by which it is left out of the photo. Only this sum is
/// computed: the difference is smooth where both show the same tissue, so it may be coarse, and the photo
/// keeps every detail of its own.
///
/// A band is the difference between one level and the next, band k = Gₖ − Gₖ₊₁ with share sₖ. Σ sₖ (Gₖ −
/// Gₖ₊₁) = Σ (sₖ − sₖ₋₁) Gₖ, so that levels can be added as they are made, each by how much more of its band
/// than of the finer one is left out, and no band is ever kept. Shares are taken at the size of the finest:
/// in coarse pixels the border itself would lie between two of them, and a part of the difference stay there.
cv::Mat correction(const cv::Mat& difference, const cv::Mat& depth, int levels) {
    cv::Mat added(difference.size(), CV_32FC3, cv::Scalar::all(0)), coarse = difference;
    std::vector<cv::Size> sizes;
    for (int level = 0; level <= levels; ++level) {
        sizes.push_back(coarse.size());
        const cv::Mat here = widened(coarse, sizes, static_cast<std::size_t>(level));
        const float border = std::ldexp(borderPerPixel, level);
        tbb::parallel_for(0, added.rows, [&](int y) {
            for (int x = 0; x < added.cols; ++x) {
                const float inside = depth.at<float>(y, x);
                const float finer = level > 0 ? leftOut(inside, border / 2) : 0;
                added.at<cv::Vec3f>(y, x) += (leftOut(inside, border) - finer) * here.at<cv::Vec3f>(y, x);
            }
        });
        if (level == levels) break;
        cv::Mat halved;
        cv::pyrDown(coarse, halved);
        coarse = halved;
    }
    return added;
}

/// Adds the correction to a row of the photo.
void correctRow(const Image& photo, const cv::Mat& added, int y, Image& picture) {
    const Image size{added.cols, added.rows, {}};
    const double perColumn = static_cast<double>(added.cols) / photo.width;
    const double row = (y + 0.5) * added.rows / photo.height;
    for (int x = 0; x < photo.width; ++x) {
        const BilinearPlace p = bilinearPlace(size, (x + 0.5) * perColumn, row);
        const auto u = static_cast<float>(p.u), v = static_cast<float>(p.v);
        const cv::Vec3f more = (1 - v) * ((1 - u) * added.at<cv::Vec3f>(p.top, p.left) +
                                          u * added.at<cv::Vec3f>(p.top, p.right)) +
                               v * ((1 - u) * added.at<cv::Vec3f>(p.bottom, p.left) +
                                    u * added.at<cv::Vec3f>(p.bottom, p.right));
        const std::uint8_t* from = photo.at(x, y);
        std::uint8_t* to = picture.at(x, y);
        for (int channel = 0; channel < 3; ++channel)
            to[channel] = static_cast<std::uint8_t>(
                std::clamp(static_cast<float>(from[channel]) + more[channel] + 0.5F, 0.0F, 255.0F));
        to[3] = from[3];
    }
}

/// What all bands add to a photo, in the size of `beneath`.
cv::Mat addedByBands(const PhotoSampler& sampler, const Image& beneath, const Image& mask, double border) {
    const cv::Size size(beneath.width, beneath.height);
    cv::Mat small = reduced(sampler, size);
    const cv::Mat difference = differenceFrom(small, beneath); // also of what is erased: filters read beyond
    if (!mask.empty()) erase(small, mask);
    const double widest =
        std::max(0.25 * std::min(size.width, size.height), border * size.width / sampler.width());
    return correction(difference, depthInside(small), coarsestLevel(size, widest));
}

} // namespace

PhotoSize comparedSize(PhotoSize photo) {
    while (std::max(photo.width, photo.height) > longestSide)
        photo = {(photo.width + 1) / 2, (photo.height + 1) / 2};
    return photo;
}

Image blendedInBands(const Image& photo, const PhotoSampler& sampler, const Image& beneath, const Image& mask,
                     double border, const Progress& progress) {
    const cv::Mat added = addedByBands(sampler, beneath, mask, border);
    Image picture{photo.width, photo.height, std::vector<std::uint8_t>(photo.pixels.size())};
    forEachInParallel(static_cast<std::size_t>(photo.height), progress,
                      [&](std::size_t y) { correctRow(photo, added, static_cast<int>(y), picture); });
    return picture;
}

Image bandsAddedTo(const PhotoSampler& sampler, const Image& beneath, const Image& mask, double border) {
    const cv::Mat added = addedByBands(sampler, beneath, mask, border);
    Image picture{beneath.width, beneath.height, std::vector<std::uint8_t>(beneath.pixels.size(), 255)};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                picture.at(x, y)[channel] = static_cast<std::uint8_t>(
                    std::clamp(added.at<cv::Vec3f>(y, x)[channel] / 2 + 128.5F, 0.0F, 255.0F));
    return picture;
}

} // namespace esm
