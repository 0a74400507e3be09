#include "tests/support/made_field.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace esm {

namespace {

using Outline = std::vector<cv::Point2d>;

constexpr double turn = 2 * CV_PI;

Outline ellipse(cv::Point2d centre, double a, double b, double angle) {
    Outline outline;
    for (int i = 0; i < 720; ++i) {
        const double t = turn * i / 720, x = a * std::cos(t), y = b * std::sin(t);
        outline.push_back(centre + cv::Point2d(x * std::cos(angle) - y * std::sin(angle),
                                               x * std::sin(angle) + y * std::cos(angle)));
    }
    return outline;
}

Outline octagon(const cv::Rect2d& box, double cutX, double cutY) {
    const double left = box.x, top = box.y, right = box.x + box.width, bottom = box.y + box.height;
    return {{left + cutX, top},     {right - cutX, top},   {right, top + cutY},   {right, bottom - cutY},
            {right - cutX, bottom}, {left + cutX, bottom}, {left, bottom - cutY}, {left, top + cutY}};
}

Outline roundedBox(const cv::Rect2d& box, double radius) {
    Outline outline;
    for (int corner = 0; corner < 4; ++corner)
        for (int i = 0; i <= 30; ++i) {
            const double t = turn * (corner + i / 30.0) / 4;
            const double x = corner == 0 || corner == 3 ? box.x + box.width - radius : box.x + radius;
            const double y = corner < 2 ? box.y + box.height - radius : box.y + radius;
            outline.emplace_back(x + radius * std::cos(t), y + radius * std::sin(t));
        }
    return outline;
}

/// Drawn four times as large and halved twice, for edges without stairs.
MadeField drawn(std::string name, cv::Size frame, const Outline& outline) {
    constexpr int finer = 4;
    std::vector<cv::Point> places;
    for (const cv::Point2d& place : outline)
        places.emplace_back(cvRound(finer * place.x - 0.5), cvRound(finer * place.y - 0.5));
    cv::Mat fine = cv::Mat::zeros(frame * finer, CV_8U);
    cv::fillPoly(fine, std::vector<std::vector<cv::Point>>{places}, 255);
    MadeField field{std::move(name), frame, {}, {}};
    cv::resize(fine, fine, frame, 0, 0, cv::INTER_AREA);
    fine.convertTo(field.share, CV_32F, 1 / 255.0);
    field.mask = fine >= 128;
    return field;
}

MadeField wholeFrame(cv::Size frame) {
    return {"fills the frame", frame, cv::Mat(frame, CV_8U, 255), cv::Mat(frame, CV_32F, 1.0)};
}

/// A circle cut by so many sides of the frame; of four, only its corners stay dark.
MadeField circle(int cuts, cv::Size frame, cv::RNG& random) {
    const double w = frame.width, h = frame.height;
    cv::Point2d centre(w / 2 + random.uniform(-0.05, 0.05) * w, h / 2);
    double radius = 0.44 * h;
    if (cuts == 1) centre.y = random.uniform(0.3, 0.4) * h;
    if (cuts == 2) radius = random.uniform(0.52, 0.62) * h;
    if (cuts == 3) {
        radius = random.uniform(0.54, 0.62) * h;
        centre.x = random.uniform(0.6, 0.85) * radius;
    }
    if (cuts == 4) {
        centre.x = w / 2 + random.uniform(-0.01, 0.01) * w;
        radius = random.uniform(0.84, 0.93) * std::hypot(w, h) / 2;
    }
    return drawn("circle cut by " + std::to_string(cuts) + " sides", frame,
                 ellipse(centre, radius, radius, 0));
}

MadeField beyondFrame(int variant, cv::Size frame, cv::RNG& random) {
    const double w = frame.width, h = frame.height;
    const double more = random.uniform(0.0, 0.06);
    if (variant % 2 == 0)
        return drawn("ellipse larger than the frame", frame,
                     ellipse({w / 2, h / 2}, (0.58 + more) * w, (0.55 + more) * h, 0));
    return drawn("octagon to the sides", frame,
                 octagon({0, 0, w, h}, random.uniform(0.15, 0.3) * w, random.uniform(0.15, 0.3) * h));
}

MadeField squeezed(int variant, cv::Size frame, cv::RNG& random) {
    const double w = frame.width, h = frame.height;
    const double longer = 0.45 * std::min(w, h / 0.7), angle = variant < 4 ? 0 : random.uniform(-0.4, 0.4);
    const bool stands = variant == 1;
    const cv::Point2d centre(w / 2 + random.uniform(-0.03, 0.03) * w, h / 2);
    return drawn("ellipse", frame,
                 stands ? ellipse(centre, 0.32 * h, 0.32 * h / 0.7, 0)
                        : ellipse(centre, longer, 0.7 * longer, angle));
}

} // namespace

MadeField madeField(int kind, int variant, cv::RNG& random) {
    static constexpr std::array<std::array<int, 2>, 6> wide{
        {{640, 480}, {720, 576}, {1920, 1080}, {800, 600}, {320, 240}, {1280, 720}}};
    static constexpr std::array<std::array<int, 2>, 6> square{
        {{280, 280}, {512, 512}, {640, 512}, {1280, 1024}, {360, 288}, {400, 400}}};
    const auto& sizes = kind == 4 || kind == 9 ? square : wide;
    const auto& size = sizes.at(static_cast<std::size_t>((variant + kind) % 6));
    const double share = size[0] == 1920 && kind % 4 != 0 ? 0.5 : 1; // some are large, as that takes time
    const cv::Size frame(cvRound(share * size[0]), cvRound(share * size[1]));
    const double w = frame.width, h = frame.height;
    const double side = random.uniform(0.02, 0.12);
    const cv::Rect2d box(side * w, 0.04 * h, (1 - 2 * side) * w, 0.92 * h);
    if (kind <= 4) return circle(kind, frame, random);
    if (kind == 5) return squeezed(variant, frame, random);
    if (kind == 6)
        return drawn("octagon", frame,
                     octagon(box, random.uniform(0.12, 0.3) * h, random.uniform(0.12, 0.3) * h));
    if (kind == 7) return drawn("rounded rectangle", frame, roundedBox(box, random.uniform(0.08, 0.3) * h));
    if (kind == 8) return wholeFrame(frame);
    return beyondFrame(variant, frame, random);
}

} // namespace esm
