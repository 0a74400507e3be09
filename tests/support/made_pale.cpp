#include "tests/support/made_pale.h"

#include "tests/support/made_tissue.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace esm {

namespace {

/// A polyp, a hyperplastic one, a gallbladder, and what is covered with fat.
const std::array<TissueColour, 4> paleColours{
    {{0.90F, 0.74F, 0.69F}, {0.93F, 0.86F, 0.82F}, {0.84F, 0.80F, 0.82F}, {0.92F, 0.85F, 0.70F}}};

double scaleOf(const cv::Size& size) {
    return std::max(1.0, std::max(size.width, size.height) / 960.0);
}

/// How far each pixel lies from an ellipse's middle, 1 at its border, which winds a little; float.
cv::Mat wayOut(cv::Size size, double across, cv::RNG& random) {
    const double x = size.width * random.uniform(0.25, 0.75), y = size.height * random.uniform(0.25, 0.75);
    const double angle = random.uniform(0.0, CV_PI), flat = random.uniform(0.5, 1.0);
    const cv::Mat winding = layeredNoise(size, 0.6 * across, 2, random);
    cv::Mat way(size, CV_32F);
    for (int row = 0; row < size.height; ++row)
        for (int column = 0; column < size.width; ++column) {
            const double along = std::cos(angle) * (column - x) + std::sin(angle) * (row - y);
            const double aside = std::cos(angle) * (row - y) - std::sin(angle) * (column - x);
            const double bent = 1 + 0.4 * (winding.at<float>(row, column) - 0.75);
            way.at<float>(row, column) =
                static_cast<float>(bent * std::hypot(along * flat, aside) / (0.5 * across));
        }
    return way;
}

/// A ball turns away from the lamp towards its border; the lamp stands somewhat aside.
cv::Mat ballShade(const cv::Mat& way, cv::RNG& random) {
    const double least = random.uniform(0.5, 0.75);
    cv::Mat shade = 1 - cv::min(way.mul(way), 1.0), across;
    cv::sqrt(shade, shade);
    const double reach = std::max(way.cols, way.rows);
    cv::Sobel(way, across, CV_32F, 1, 0, 3, random.uniform(-0.3, 0.3) * reach / 640);
    return cv::min(least + (1 - least) * shade + cv::min(cv::max(across, -0.15), 0.15), 1.0);
}

void addPaleObject(cv::Mat& tissue, cv::Mat& objects, cv::RNG& random) {
    const cv::Size size = tissue.size();
    const double largest = std::min(200 * scaleOf(size), 0.4 * size.height), least = 25 * scaleOf(size);
    const double across = least * std::pow(largest / least, random.uniform(0.0, 1.0));
    const cv::Mat way = wayOut(size, across, random);
    const TissueColour& pale = paleColours.at(static_cast<std::size_t>(random.uniform(0, 4)));
    cv::Mat colours(size, CV_32FC3, cv::Scalar(pale[0], pale[1], pale[2]));
    mixIn(colours, {0.80F, 0.56F, 0.52F},
          random.uniform(0.1, 0.4) * smoothStep(layeredNoise(size, 0.3 * across, 4, random), 0.35, 0.7));
    mixIn(colours, {0.70F, 0.30F, 0.32F},
          random.uniform(0.0, 0.5) * vessels(size, 0.5 * across, 0.03, random));
    colours = colours.mul(inThree(ballShade(way, random)));
    const double border = random.uniform(1.0, 3.0) / (0.5 * across);
    const cv::Mat share = inThree(1 - smoothStep(way, 1 - border, 1 + border));
    tissue += share.mul(colours - tissue);
    objects |= way < 1;
}

} // namespace

cv::Mat addPaleObjects(cv::Mat& tissue, cv::RNG& random) {
    cv::Mat objects = cv::Mat::zeros(tissue.size(), CV_8U);
    const int count = random.uniform(1, 4);
    for (int i = 0; i < count; ++i)
        addPaleObject(tissue, objects, random);
    return objects;
}

void addFlecksOn(const cv::Mat& objects, cv::Mat& shine, cv::RNG& random) {
    std::vector<cv::Point> places;
    cv::findNonZero(objects, places);
    if (places.empty()) return;
    const int flecks = random.uniform(3, 12);
    for (int i = 0; i < flecks; ++i) {
        const cv::Point place =
            places[static_cast<std::size_t>(random.uniform(0, static_cast<int>(places.size())))];
        addFleck(shine, place, scaleOf(shine.size()) * random.uniform(2.0, 9.0), random);
    }
}

} // namespace esm
