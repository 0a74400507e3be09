#include "core/texture/photo/straightening.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include <cmath>
#include <random>

using namespace esm;

namespace {

constexpr PhotoSize size{1920, 1080};
const double half = 0.5 * std::hypot(1920, 1080);

Lens knownLens(LensKind kind, double k1, double k2) {
    return {kind, {half, half, 960, 540}, {k1, k2, 0, 0, 0}};
}

/// Where OpenCV says that a lens shows places of the straight picture.
DrawnLine bentByOpenCv(const Lens& lens, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double noise,
                       std::mt19937& random) {
    std::vector<cv::Point3d> points;
    for (int i = 0; i < 12; ++i) {
        const Eigen::Vector2d place = from + i / 11.0 * (to - from);
        points.emplace_back((place.x() - 960) / half, (place.y() - 540) / half, 1);
    }
    const cv::Matx33d camera(half, 0, 960, 0, half, 540, 0, 0, 1);
    const auto& k = lens.coefficients;
    std::vector<cv::Point2d> bent;
    if (lens.kind == LensKind::Pinhole)
        cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), camera, cv::Vec4d(k[0], k[1], 0, 0), bent);
    else
        cv::fisheye::projectPoints(points, bent, cv::Vec3d(), cv::Vec3d(), camera,
                                   cv::Vec4d(k[0], k[1], 0, 0));
    std::normal_distribution<double> off(0, noise);
    DrawnLine line;
    for (const cv::Point2d& point : bent)
        line.emplace_back(point.x + (noise > 0 ? off(random) : 0), point.y + (noise > 0 ? off(random) : 0));
    return line;
}

std::vector<DrawnLine> linesOf(const Lens& lens, std::size_t count, double noise) {
    const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> straight{{{150, 120}, {1750, 90}},
                                                                            {{120, 1000}, {1800, 960}},
                                                                            {{200, 80}, {230, 1010}},
                                                                            {{1700, 60}, {1650, 1000}},
                                                                            {{300, 700}, {1600, 800}}};
    std::mt19937 random(3);
    std::vector<DrawnLine> lines;
    for (std::size_t i = 0; i < count; ++i)
        lines.push_back(bentByOpenCv(lens, straight[i].first, straight[i].second, noise, random));
    return lines;
}

std::string straighteningRefusal(const std::vector<DrawnLine>& lines) {
    try {
        straighteningLens(LensKind::Pinhole, size, lines);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return {};
}

/// The largest distance, in pixels, between where two lenses show places of the photo.
double difference(const Lens& a, const Lens& b) {
    double most = 0;
    for (int y = 0; y <= 1080; y += 90)
        for (int x = 0; x <= 1920; x += 96)
            most = std::max(most, (distorted(a, {x, y}) - distorted(b, {x, y})).norm());
    return most;
}

} // namespace

TEST(Straightening, FindsAKnownLens) {
    for (const LensKind kind : {LensKind::Pinhole, LensKind::Fisheye})
        for (const double k1 : {-0.25, -0.08, 0.1}) {
            const Lens one = knownLens(kind, k1, 0), two = knownLens(kind, k1, 0.03);
            const Lens ofTwo = straighteningLens(kind, size, linesOf(one, 2, 0));
            EXPECT_NEAR(ofTwo.coefficients[0], k1, 1e-6);
            EXPECT_EQ(ofTwo.coefficients[1], 0);
            const Lens ofFive = straighteningLens(kind, size, linesOf(two, 5, 0));
            EXPECT_NEAR(ofFive.coefficients[0], k1, 1e-5);
            EXPECT_NEAR(ofFive.coefficients[1], 0.03, 1e-5);
            EXPECT_LT(bending(ofFive, linesOf(two, 5, 0)), 1e-6);
            EXPECT_GT(bending(knownLens(LensKind::Pinhole, 0, 0), linesOf(two, 5, 0)), 1);
        }
}

TEST(Straightening, BearsHalfAPixelOfNoise) {
    for (const LensKind kind : {LensKind::Pinhole, LensKind::Fisheye}) {
        const Lens one = knownLens(kind, -0.2, 0), two = knownLens(kind, -0.2, 0.03);
        EXPECT_LT(difference(straighteningLens(kind, size, linesOf(one, 2, 0.5)), one), 8);
        EXPECT_LT(difference(straighteningLens(kind, size, linesOf(two, 5, 0.5)), two), 12);
    }
}

TEST(Straightening, UndoesWhatALensDoes) {
    for (const LensKind kind : {LensKind::Pinhole, LensKind::Fisheye}) {
        const Lens lens = knownLens(kind, -0.15, 0.02);
        for (int y = 0; y <= 1080; y += 60)
            for (int x = 0; x <= 1920; x += 60)
                EXPECT_LT((straightened(lens, distorted(lens, {x, y})) - Eigen::Vector2d(x, y)).norm(), 1e-6);
    }
    // A lens that bends back shows nothing beyond.
    EXPECT_FALSE(straightened(knownLens(LensKind::Pinhole, -0.9, 0), {1919, 1079}).allFinite());
}

TEST(Straightening, RefusesWhatTellsNothing) {
    using testing::HasSubstr;
    const std::vector<DrawnLine> lines = linesOf(knownLens(LensKind::Pinhole, -0.2, 0), 2, 0);
    EXPECT_THAT(straighteningRefusal({}), HasSubstr("two lines"));
    EXPECT_THAT(straighteningRefusal({lines[0]}), HasSubstr("two lines"));
    EXPECT_THAT(straighteningRefusal({lines[0], {lines[1][0], lines[1][1]}}), HasSubstr("two lines"));
    EXPECT_EQ(straighteningRefusal(lines), "");
    const DrawnLine through{{0, 0}, {480, 270}, {960, 540}, {1920, 1080}};
    const DrawnLine across{{0, 540}, {500, 540}, {1500, 540}};
    EXPECT_THAT(straighteningRefusal({through, across}), HasSubstr("do not tell"));
    const DrawnLine dot{{300, 200}, {300, 200}, {300, 200}};
    EXPECT_THAT(straighteningRefusal({dot, dot}), HasSubstr("do not tell"));
    const DrawnLine shortOne{{300, 200}, {306, 200}, {312, 201}},
        shortTwo{{600, 200}, {606, 201}, {612, 201}};
    EXPECT_THAT(straighteningRefusal({shortOne, shortTwo}), HasSubstr("do not tell"));
}
