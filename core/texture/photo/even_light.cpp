#include "core/texture/photo/even_light.h"

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

constexpr int coarse = 192;        ///< pixels of the longer side at which light is looked at
constexpr double darkestLight = 8; ///< luminance below which noise would count for light
constexpr double strongestGain = 3;
constexpr int degrees = 4;
constexpr int termCount = (degrees + 1) * (degrees + 2) / 2;

using Terms = Eigen::Matrix<double, termCount, 1>;

/// Luminance × weight, and weight, of which a coarse picture holds enough.
cv::Mat weightedLuminance(const Image& photo) {
    cv::Mat weighted(photo.height, photo.width, CV_32FC2);
    tbb::parallel_for(0, photo.height, [&](int y) {
        for (int x = 0; x < photo.width; ++x) {
            const std::uint8_t* p = photo.at(x, y);
            const float luminance = 0.2126F * p[0] + 0.7152F * p[1] + 0.0722F * p[2];
            const float weight = static_cast<float>(p[3]) / 255;
            weighted.at<cv::Vec2f>(y, x) = {luminance * weight, weight};
        }
    });
    const double scale = std::min(1.0, static_cast<double>(coarse) / std::max(photo.width, photo.height));
    const cv::Size size(std::max(1, static_cast<int>(std::lround(photo.width * scale))),
                        std::max(1, static_cast<int>(std::lround(photo.height * scale))));
    cv::Mat small;
    cv::resize(weighted, small, size, 0, 0, cv::INTER_AREA);
    return small;
}

/// 1, x, y, x², xy, y², … up to the fourth degree: slow enough to leave the tissue its own light and shade.
Terms termsAt(double x, double y) {
    Terms terms;
    Eigen::Index next = 0;
    for (int degree = 0; degree <= degrees; ++degree)
        for (int ofY = 0; ofY <= degree; ++ofY)
            terms[next++] = std::pow(x, degree - ofY) * std::pow(y, ofY);
    return terms;
}

Terms termsOf(const cv::Mat& small, int x, int y) {
    const double half = 0.5 * std::max(small.cols, small.rows);
    return termsAt((x + 0.5 - 0.5 * small.cols) / half, (y + 0.5 - 0.5 * small.rows) / half);
}

/// The logarithm of the light as it changes slowly over the photo, and its mean.
struct SlowLight {
    Terms factors;
    double mean;
};

std::optional<SlowLight> fittedLight(const cv::Mat& small) {
    Eigen::Matrix<double, termCount, termCount> normal =
        Eigen::Matrix<double, termCount, termCount>::Identity() * 1e-6;
    Terms right = Terms::Zero();
    double sum = 0, weights = 0;
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const cv::Vec2f& light = small.at<cv::Vec2f>(y, x);
            const double weight = light[1];
            if (!(weight > 0.01)) continue;
            const double level = std::log(std::max(darkestLight, light[0] / weight));
            const Terms terms = termsOf(small, x, y);
            normal += weight * terms * terms.transpose();
            right += weight * level * terms;
            sum += weight * level;
            weights += weight;
        }
    if (!(weights > 0)) return std::nullopt;
    return SlowLight{normal.ldlt().solve(right), sum / weights};
}

/// What to multiply with, coarse; empty where nothing counts.
cv::Mat coarseGains(const Image& photo, double strength) {
    const cv::Mat small = weightedLuminance(photo);
    const std::optional<SlowLight> light = fittedLight(small);
    if (!light) return {};
    const double strongest = std::log(strongestGain);
    cv::Mat gains(small.size(), CV_32F);
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const double gain = light->mean - light->factors.dot(termsOf(small, x, y));
            gains.at<float>(y, x) =
                static_cast<float>(std::exp(strength * std::clamp(gain, -strongest, strongest)));
        }
    return gains;
}

} // namespace

void evenLight(Image& photo, double strength) {
    if (photo.empty() || !(strength > 0)) return;
    cv::Mat gains = coarseGains(photo, strength);
    if (gains.empty()) return;
    cv::resize(gains, gains, {photo.width, photo.height}, 0, 0, cv::INTER_LINEAR);
    tbb::parallel_for(0, photo.height, [&](int y) {
        for (int x = 0; x < photo.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                std::uint8_t& value = photo.at(x, y)[channel];
                const float lit = static_cast<float>(value) * gains.at<float>(y, x) + 0.5F;
                value = static_cast<std::uint8_t>(std::min(lit, 255.0F));
            }
    });
}

} // namespace esm
