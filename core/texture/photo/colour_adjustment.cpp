#include "core/texture/photo/colour_adjustment.h"

#include "core/support/angles.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

using ToneCurve = std::array<float, 256>; ///< of an sRGB value, 0 to 1

/// Levels and contrast, as one curve for all three channels.
ToneCurve toneCurve(const ColourAdjustment& adjustment) {
    ToneCurve curve{};
    for (std::size_t value = 0; value < curve.size(); ++value) {
        const double share = (static_cast<double>(value) - adjustment.blackPoint) /
                             (adjustment.whitePoint - adjustment.blackPoint);
        const double levelled = std::pow(std::clamp(share, 0.0, 1.0), 1 / adjustment.gamma);
        curve[value] = static_cast<float>(std::clamp(0.5 + adjustment.contrast * (levelled - 0.5), 0.0, 1.0));
    }
    return curve;
}

/// Chroma is a length in the plane of the two colour axes and hue an angle in it, so that saturation and hue
/// are one similarity of that plane. In HSV, where both are often changed, lightness would change with them:
/// blue tissue would turn dark and yellow one glare.
class ChromaTurn {
public:
    explicit ChromaTurn(const ColourAdjustment& adjustment)
        : m_cosine(static_cast<float>(adjustment.saturation * std::cos(toRadians(adjustment.hue)))),
          m_sine(static_cast<float>(adjustment.saturation * std::sin(toRadians(adjustment.hue)))) {}

    void operator()(cv::Vec3f& lab) const {
        const float a = lab[1], b = lab[2];
        lab[1] = m_cosine * a - m_sine * b;
        lab[2] = m_sine * a + m_cosine * b;
    }

private:
    float m_cosine, m_sine;
};

void turnChroma(cv::Mat& row, const ChromaTurn& turn) {
    cv::cvtColor(row, row, cv::COLOR_RGB2Lab);
    for (int x = 0; x < row.cols; ++x)
        turn(row.at<cv::Vec3f>(0, x));
    cv::cvtColor(row, row, cv::COLOR_Lab2RGB);
}

} // namespace

std::vector<std::string> validate(const ColourAdjustment& adjustment) {
    std::vector<std::string> problems = fieldProblems(adjustment);
    if (problems.empty() && adjustment.whitePoint - adjustment.blackPoint < 1)
        problems.emplace_back("the white point must lie above the black point by 1 at least");
    return problems;
}

/// A row at a time, and rounded once, at the end: levels that pull shadows apart would else show steps.
void adjustColours(Image& photo, const ColourAdjustment& adjustment) {
    if (adjustment == ColourAdjustment()) return;
    const ToneCurve curve = toneCurve(adjustment);
    const ChromaTurn turn(adjustment);
    const bool turnsChroma = adjustment.saturation != 1 || adjustment.hue != 0;
    tbb::parallel_for(0, photo.height, [&](int y) {
        cv::Mat row(1, photo.width, CV_32FC3);
        for (int x = 0; x < photo.width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                row.at<cv::Vec3f>(0, x)[channel] = curve[photo.at(x, y)[channel]];
        if (turnsChroma) turnChroma(row, turn);
        for (int x = 0; x < photo.width; ++x) {
            std::uint8_t* pixel = photo.at(x, y);
            if (pixel[3] == 0) continue;
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = static_cast<std::uint8_t>(
                    std::lround(255 * std::clamp(row.at<cv::Vec3f>(0, x)[channel], 0.0F, 1.0F)));
        }
    });
}

} // namespace esm
