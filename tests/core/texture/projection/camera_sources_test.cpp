#include "core/texture/projection/camera_sources.h"

#include "tests/core/texture/projection/seen_pairs.h"

#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;

namespace {

/// Landmarks that such a camera sees, clicked with an error of one pixel.
std::vector<LandmarkPair> clickedPairs(const Intrinsics& intrinsics, std::size_t count = 12) {
    Projector seeing = camera();
    seeing.intrinsics = intrinsics;
    std::vector<LandmarkPair> pairs = pairsSeenBy(seeing, count);
    addNoise(pairs, 1);
    return pairs;
}

double turnedOff(const PoseFit& fit) {
    return toDegrees(
        Eigen::AngleAxisd(camera().pose.linear().transpose() * fit.projector.pose.linear()).angle());
}

} // namespace

TEST(CameraSources, FindsALineOfSightFarFromTheMiddle) {
    const Intrinsics cropped{1200, 1200, 500, 800};
    const PoseFit fit = fitPose(clickedPairs(cropped), {endoscope, std::nullopt});
    EXPECT_EQ(fit.principalPoint, PartSource::Found);
    ASSERT_TRUE(fit.projector.intrinsics);
    EXPECT_TRUE(fit.projector.areIntrinsicsFound);
    EXPECT_NEAR(fit.projector.intrinsics->cx, 500, 40);
    EXPECT_NEAR(fit.projector.intrinsics->cy, 800, 40);
    EXPECT_LT(turnedOff(fit), 1); // with the line of sight in the middle it would be 20°
    EXPECT_FALSE(fit.dominating);
}

TEST(CameraSources, FindsPixelsThatAreNotSquare) {
    for (const double stretch : {0.75, 1.07, 1.33}) {
        const PoseFit fit =
            fitPose(clickedPairs({stretch * 1200, 1200, 960, 540}), {endoscope, std::nullopt});
        EXPECT_EQ(fit.pixelAspect, PartSource::Found);
        ASSERT_TRUE(fit.projector.intrinsics) << stretch;
        EXPECT_NEAR(fit.projector.intrinsics->fx / fit.projector.intrinsics->fy, stretch, 0.02);
        EXPECT_EQ(std::count(fit.outliers.begin(), fit.outliers.end(), true), 0);
    }
}

TEST(CameraSources, KeepsAUsualCameraUsual) {
    const PoseFit fit = fitPose(clickedPairs({1200, 1200, 960, 540}), {endoscope, std::nullopt});
    EXPECT_EQ(fit.focalLength, PartSource::Found);
    EXPECT_FALSE(fit.projector.intrinsics);
    EXPECT_FALSE(fit.projector.areIntrinsicsFound);
}

TEST(CameraSources, NamesTheAssumptionThatThePoseHangsOn) {
    const PoseFit fit = fitPose(clickedPairs({1200, 1200, 960, 540}, 4), {endoscope, std::nullopt});
    EXPECT_EQ(fit.principalPoint, PartSource::Assumed);
    EXPECT_EQ(fit.dominating, CameraPart::PrincipalPoint);
    const PoseFit given =
        fitPose(clickedPairs({1200, 1200, 960, 540}, 4), {endoscope, Intrinsics{1200, 1200, 960, 540}});
    EXPECT_EQ(given.principalPoint, PartSource::Given);
    EXPECT_FALSE(given.dominating);
    EXPECT_LT(given.turnWithin, fit.turnWithin / 2);
}
