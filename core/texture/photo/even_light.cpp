#include "core/texture/photo/even_light.h"

#include "core/support/smooth_step.h"

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Light changes slowly, so a coarse picture holds all of it and averages texture and noise away; the photo
/// itself is only multiplied.
constexpr int coarse = 192;         ///< pixels of the longer side at which light is looked at
constexpr double darkestLight = 8;  ///< luminance below which noise would count for light
constexpr double raisedInFull = 24; ///< luminance from which on a place may be brightened by all of its gain
constexpr double strongestGain = 3;
constexpr int degrees = 4;
constexpr int termCount = (degrees + 1) * (degrees + 2) / 2;

using Terms = Eigen::Matrix<double, termCount, 1>;

constexpr float noLight = -1; ///< luminance of what is transparent, which is not dark

/// Mean luminance of the part of the photo that a coarse pixel stands for, and how much of it counts.
cv::Vec2f meanLuminance(const Image& photo, const cv::Rect& part) {
    double luminance = 0, weight = 0;
    for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) {
            const std::uint8_t* p = photo.at(x, y);
            luminance += p[3] * (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]);
            weight += p[3];
        }
    if (!(weight > 0)) return {noLight, 0};
    return {static_cast<float>(luminance / weight), static_cast<float>(weight / (255.0 * part.area()))};
}

/// Luminance and weight, of which a coarse picture holds enough. What is nearly black has no light to even.
cv::Mat coarseLuminance(const Image& photo) {
    const double scale = std::min(1.0, static_cast<double>(coarse) / std::max(photo.width, photo.height));
    const int width = std::max(1, static_cast<int>(std::lround(photo.width * scale)));
    const int height = std::max(1, static_cast<int>(std::lround(photo.height * scale)));
    const auto begin = [](int part, int parts, int size) {
        return static_cast<int>(static_cast<std::int64_t>(part) * size / parts);
    };
    cv::Mat small(height, width, CV_32FC2);
    tbb::parallel_for(0, height, [&](int y) {
        const int top = begin(y, height, photo.height), bottom = begin(y + 1, height, photo.height);
        for (int x = 0; x < width; ++x) {
            const int left = begin(x, width, photo.width), right = begin(x + 1, width, photo.width);
            cv::Vec2f mean = meanLuminance(photo, {left, top, right - left, bottom - top});
            if (mean[0] < darkestLight) mean[1] = 0;
            small.at<cv::Vec2f>(y, x) = mean;
        }
    });
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

/// Places from −1 to 1 along the longer side, in which powers up to the fourth keep the equations well
/// conditioned.
Terms termsOf(const cv::Mat& small, int x, int y) {
    const double half = 0.5 * std::max(small.cols, small.rows);
    return termsAt((x + 0.5 - 0.5 * small.cols) / half, (y + 0.5 - 0.5 * small.rows) / half);
}

/// The logarithm of the light as it changes slowly over the photo; nothing where nothing counts.
///
/// What a camera sees is light × reflectance. The logarithm makes a sum of it, of which a least-squares
/// polynomial takes the slow part, for the light: the model of retinex (Land and McCann 1971). A blur is the
/// usual way to the slow part. A polynomial has no radius to choose, leaves no halo at edges, and goes on
/// under what is masked out. The small multiple of the identity keeps the equations solvable where too few
/// pixels count for fifteen terms.
std::optional<Terms> slowLight(const cv::Mat& small) {
    Eigen::Matrix<double, termCount, termCount> normal =
        Eigen::Matrix<double, termCount, termCount>::Identity() * 1e-6;
    Terms right = Terms::Zero();
    double weights = 0;
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const auto [luminance, weight] = small.at<cv::Vec2f>(y, x).val;
            if (!(weight > 0.01F)) continue;
            const Terms terms = termsOf(small, x, y);
            normal += weight * terms * terms.transpose();
            right += weight * std::log(static_cast<double>(luminance)) * terms;
            weights += weight;
        }
    if (!(weights > 0)) return std::nullopt;
    return Terms(normal.ldlt().solve(right));
}

/// Scales gains so that the photo is as bright on the whole as it was. Light is evened towards the value in
/// the middle, where an endoscope's lamp is brightest: without this the rim would be raised and the photo be
/// brighter by as much.
void keepBrightness(const cv::Mat& small, cv::Mat& gains) {
    double before = 0, after = 0;
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const cv::Vec2f& light = small.at<cv::Vec2f>(y, x);
            before += static_cast<double>(light[0]) * light[1];
            after += static_cast<double>(light[0]) * light[1] * gains.at<float>(y, x);
        }
    gains *= before / after;
    gains = cv::min(cv::max(gains, 1 / strongestGain), strongestGain);
}

/// Nearly black places hold the camera's noise and little else: brightened, it would be coloured specks.
void spareTheDark(const cv::Mat& small, cv::Mat& gains) {
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            float& gain = gains.at<float>(y, x);
            const float luminance = small.at<cv::Vec2f>(y, x)[0];
            if (gain <= 1 || luminance == noLight) continue;
            const double share = smoothStep(darkestLight, raisedInFull, luminance);
            gain = static_cast<float>(1 + share * (gain - 1));
        }
}

/// What to multiply with, coarse; empty where nothing counts. The clamp comes before the strength, so that a
/// corner in which the polynomial runs away is held at a factor of three.
cv::Mat coarseGains(const Image& photo, double strength) {
    const cv::Mat small = coarseLuminance(photo);
    const std::optional<Terms> light = slowLight(small);
    if (!light) return {};
    const double strongest = std::log(strongestGain), middle = light->dot(termsAt(0, 0));
    cv::Mat gains(small.size(), CV_32F);
    for (int y = 0; y < small.rows; ++y)
        for (int x = 0; x < small.cols; ++x) {
            const double gain = middle - light->dot(termsOf(small, x, y));
            gains.at<float>(y, x) =
                static_cast<float>(std::exp(strength * std::clamp(gain, -strongest, strongest)));
        }
    keepBrightness(small, gains);
    spareTheDark(small, gains);
    return gains;
}

/// The gains of a row of the photo, between those of the coarse rows around it.
cv::Mat gainsOfRow(const cv::Mat& gains, int y, const cv::Size& photo) {
    const float place = std::clamp((static_cast<float>(y) + 0.5F) * static_cast<float>(gains.rows) /
                                           static_cast<float>(photo.height) -
                                       0.5F,
                                   0.0F, static_cast<float>(gains.rows - 1));
    const int above = static_cast<int>(place), below = std::min(above + 1, gains.rows - 1);
    const float share = place - static_cast<float>(above);
    const cv::Mat coarseRow = (1 - share) * gains.row(above) + share * gains.row(below);
    cv::Mat row;
    cv::resize(coarseRow, row, {photo.width, 1}, 0, 0, cv::INTER_LINEAR);
    return row;
}

} // namespace

void evenLight(Image& photo, double strength) {
    if (photo.empty() || !(strength > 0)) return;
    const cv::Mat gains = coarseGains(photo, strength);
    if (gains.empty()) return;
    tbb::parallel_for(0, photo.height, [&](int y) {
        const cv::Mat row = gainsOfRow(gains, y, {photo.width, photo.height});
        for (int x = 0; x < photo.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                std::uint8_t& value = photo.at(x, y)[channel];
                const float lit = static_cast<float>(value) * row.at<float>(0, x) + 0.5F;
                value = static_cast<std::uint8_t>(std::min(lit, 255.0F));
            }
    });
}

} // namespace esm
