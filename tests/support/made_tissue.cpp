#include "tests/support/made_tissue.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

struct Palette {
    TissueColour dark, pale;
};

const std::array<Palette, 5> palettes{{{{0.62F, 0.30F, 0.27F}, {0.84F, 0.52F, 0.46F}},
                                       {{0.55F, 0.20F, 0.17F}, {0.76F, 0.36F, 0.30F}},
                                       {{0.74F, 0.44F, 0.30F}, {0.90F, 0.62F, 0.45F}},
                                       {{0.80F, 0.55F, 0.52F}, {0.94F, 0.77F, 0.72F}},
                                       {{0.58F, 0.32F, 0.34F}, {0.82F, 0.55F, 0.56F}}}};

/// How bright folds are by their slope, around 1.
cv::Mat foldShade(cv::Size size, cv::RNG& random) {
    const double scale = std::max(size.width, size.height);
    const cv::Mat height = layeredNoise(size, random.uniform(0.15, 0.35) * scale, 3, random);
    cv::Mat slopeX, slopeY;
    cv::Sobel(height, slopeX, CV_32F, 1, 0, 3, scale / 64);
    cv::Sobel(height, slopeY, CV_32F, 0, 1, 3, scale / 64);
    const cv::Mat shade = 1 + 0.5 * slopeX + 0.7 * slopeY;
    return cv::min(cv::max(shade, 0.55), 1.15);
}

/// The lamp lights a part more than the rest, and the rim least.
cv::Mat unevenLight(cv::Size size, cv::RNG& random) {
    const double reach = random.uniform(0.6, 1.0) * std::max(size.width, size.height);
    const double x = size.width * random.uniform(0.3, 0.7), y = size.height * random.uniform(0.3, 0.7);
    cv::Mat light(size, CV_32F);
    for (int row = 0; row < size.height; ++row)
        for (int column = 0; column < size.width; ++column) {
            const double away = std::hypot(column - x, row - y) / reach;
            light.at<float>(row, column) = static_cast<float>(1.05 / (1 + 1.4 * away * away));
        }
    return light;
}

void addLumen(cv::Mat& colours, cv::RNG& random) {
    const cv::Size size = colours.size();
    const double width = size.width * random.uniform(0.08, 0.16),
                 height = size.height * random.uniform(0.1, 0.2);
    cv::Mat hollow = cv::Mat::zeros(size, CV_32F);
    const cv::Point2d middle(size.width * random.uniform(0.2, 0.8), size.height * random.uniform(0.2, 0.8));
    cv::ellipse(hollow, cv::RotatedRect(middle, cv::Size2d(2 * width, 2 * height), 30), 1, cv::FILLED);
    cv::GaussianBlur(hollow, hollow, {}, 0.25 * width);
    mixIn(colours, TissueColour(0.09F, 0.03F, 0.03F), hollow);
}

/// A shaft of neutral metal from the lower rim, brighter along its middle.
void addInstrument(cv::Mat& colours, cv::RNG& random) {
    const cv::Size size = colours.size();
    const double width = 0.05 * size.height;
    const cv::Point2d tip(size.width * random.uniform(0.4, 0.6), size.height * random.uniform(0.45, 0.6));
    const cv::Point2d end(size.width * random.uniform(0.2, 0.8), size.height);
    for (int ring = 8; ring > 0; --ring) {
        const float grey = 0.28F + 0.055F * static_cast<float>(8 - ring);
        cv::line(colours, tip, end, cv::Scalar(grey, grey, grey), std::max(1, cvRound(width * ring / 8)),
                 cv::LINE_8);
    }
}

} // namespace

cv::Mat smoothStep(const cv::Mat& values, double from, double to) {
    cv::Mat t = (values - from) / (to - from);
    t = cv::min(cv::max(t, 0.0), 1.0);
    return t.mul(t).mul(3 - 2 * t);
}

cv::Mat inThree(const cv::Mat& one) {
    cv::Mat three;
    cv::merge(std::array<cv::Mat, 3>{one, one, one}.data(), 3, three);
    return three;
}

void mixIn(cv::Mat& colours, const TissueColour& other, const cv::Mat& share) {
    const cv::Mat by = inThree(share);
    const cv::Mat full(colours.size(), CV_32FC3, cv::Scalar(other[0], other[1], other[2]));
    colours += by.mul(full - colours);
}

/// Where layered noise passes its middle.
cv::Mat vessels(cv::Size size, double apart, double width, cv::RNG& random) {
    const cv::Mat noise = layeredNoise(size, apart, 3, random);
    return 1 - smoothStep(cv::abs(noise - 0.5), 0.3 * width, width);
}

cv::Mat layeredNoise(cv::Size size, double featureSize, int layers, cv::RNG& random) {
    cv::Mat sum = cv::Mat::zeros(size, CV_32F);
    double weights = 0;
    for (int layer = 0; layer < layers; ++layer) {
        const double feature = std::max(1.0, featureSize / (1 << layer));
        cv::Mat grid(cvCeil(size.height / feature) + 3, cvCeil(size.width / feature) + 3, CV_32F), fine;
        random.fill(grid, cv::RNG::UNIFORM, 0, 1);
        cv::resize(grid, fine, {}, feature, feature, cv::INTER_CUBIC);
        const double weight = std::pow(0.5, layer);
        sum += weight * fine(cv::Rect(cvFloor(feature), cvFloor(feature), size.width, size.height));
        weights += weight;
    }
    return sum / weights;
}

cv::Mat madeTissue(cv::Size size, int variant, cv::RNG& random) {
    const double scale = std::max(size.width, size.height);
    const Palette& palette = palettes.at(static_cast<std::size_t>(random.uniform(0, 5)));
    cv::Mat colours(size, CV_32FC3, cv::Scalar(palette.dark[0], palette.dark[1], palette.dark[2]));
    mixIn(colours, palette.pale, smoothStep(layeredNoise(size, 0.2 * scale, 5, random), 0.25, 0.75));
    mixIn(colours, {0.62F, 0.13F, 0.13F}, 0.55 * vessels(size, 0.22 * scale, 0.02, random));
    mixIn(colours, {0.52F, 0.20F, 0.28F}, 0.45 * vessels(size, 0.35 * scale, 0.025, random));
    if (variant % 3 == 1)
        mixIn(colours, {0.88F, 0.72F, 0.35F},
              0.8 * smoothStep(layeredNoise(size, 0.15 * scale, 4, random), 0.6, 0.68));
    mixIn(colours, {0.60F, 0.18F, 0.18F},
          0.3 * smoothStep(layeredNoise(size, 0.02 * scale, 4, random), 0.4, 0.8));
    colours = colours.mul(inThree(foldShade(size, random)));
    if (variant % 2 == 0) addLumen(colours, random);
    if (variant % 4 == 1) addInstrument(colours, random);
    return colours;
}

void lightUnevenly(cv::Mat& tissue, cv::RNG& random) {
    tissue = tissue.mul(inThree(unevenLight(tissue.size(), random)));
}

void addFleck(cv::Mat& shine, cv::Point at, double size, cv::RNG& random) {
    const double strength = std::pow(random.uniform(0.55, 1.5), 2.2);
    const double soft = random.uniform(0.04, 0.12) * size + 0.5;
    const int reach = cvCeil(size + 4 * soft);
    const cv::Rect part =
        cv::Rect(at.x - reach, at.y - reach, 2 * reach + 1, 2 * reach + 1) & cv::Rect({}, shine.size());
    if (part.area() == 0) return;
    cv::Mat fleck = cv::Mat::zeros(part.size(), CV_32F);
    const cv::Size2d axes(size, size * random.uniform(0.4, 1.0));
    cv::ellipse(
        fleck,
        cv::RotatedRect(cv::Point2d(at - part.tl()), axes, static_cast<float>(random.uniform(0.0, 180.0))), 1,
        cv::FILLED);
    if (size > 8) fleck = fleck.mul(smoothStep(layeredNoise(part.size(), 0.7 * size, 3, random), 0.28, 0.4));
    cv::GaussianBlur(fleck, fleck, {}, soft);
    shine(part) = cv::max(shine(part), strength * fleck);
}

cv::Mat madeShine(cv::Size size, cv::RNG& random) {
    cv::Mat shine = cv::Mat::zeros(size, CV_32F);
    const double largest = std::min(40.0, 0.07 * size.height);
    const int flecks = random.uniform(12, 50);
    for (int i = 0; i < flecks; ++i) {
        const double extent = 2 * std::pow(largest / 2, random.uniform(0.0, 1.0));
        addFleck(shine, {random.uniform(0, size.width), random.uniform(0, size.height)}, extent, random);
    }
    for (int streak = 0; streak < 2; ++streak) { // a wet fold shows many beside each other
        cv::Point at(random.uniform(size.width / 4, 3 * size.width / 4),
                     random.uniform(size.height / 4, 3 * size.height / 4));
        const cv::Point step(random.uniform(3, 9), random.uniform(-4, 5));
        for (int i = 0; i < 9; ++i, at += step)
            addFleck(shine, at, random.uniform(2.0, 6.0), random);
    }
    return shine;
}

} // namespace esm
