#include "core/texture/projection/pose_fit.h"

#include "core/support/errors.h"
#include "core/texture/projection/usual_camera.h"
#include "tests/core/texture/projection/seen_pairs.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace esm;
using namespace esm::test;
using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

namespace {

std::string poseRefusal(const std::vector<LandmarkPair>& pairs,
                        const std::optional<Intrinsics>& intrinsics = camera().intrinsics) {
    try {
        fitPose(pairs, {endoscope, intrinsics});
    } catch (const InvalidModel& error) {
        EXPECT_EQ(error.problems().size(), 1U);
        return error.what();
    }
    return "accepted";
}

} // namespace

TEST(PoseFit, FindsThePoseOfExactPairs) {
    for (const std::size_t count : {4U, 5U, 8U, 40U})
        for (const unsigned seed : {1U, 2U, 3U}) {
            const PoseFit fit = fitPose(pairsSeenBy(camera(), count, seed), {endoscope, camera().intrinsics});
            EXPECT_LT(fit.error, 1e-3) << count;
            EXPECT_LT(errorAt(fit.projector, camera()), 0.1) << count;
            EXPECT_EQ(fit.focalLength, PartSource::Given);
            EXPECT_EQ(fit.projector.intrinsics, camera().intrinsics);
            EXPECT_EQ(std::count(fit.outliers.begin(), fit.outliers.end(), true), 0);
        }
}

TEST(PoseFit, PairsOfAnotherPhotoAreRefused) {
    std::vector<LandmarkPair> pairs = pairsSeenBy(camera(), 8);
    pairs[3].photo.x() = 2.0 * endoscope.width;
    EXPECT_THAT(poseRefusal(pairs), HasSubstr("pair 4 lies outside the photo"));
}

TEST(PoseFit, FindsThePoseOfPairsThatAreAPixelOff) {
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
        std::vector<LandmarkPair> pairs = pairsSeenBy(camera(), 8, seed);
        addNoise(pairs, 1, seed);
        const PoseFit fit = fitPose(pairs, {endoscope, camera().intrinsics});
        EXPECT_LT(errorAt(fit.projector, camera()), 2) << seed;
        EXPECT_LT(fit.error, 2);
    }
}

TEST(PoseFit, MeasuresTheFocalLengthFromSixPairs) {
    for (const double degrees : {12.0, 30.0, 62.0, 110.0})
        for (const unsigned seed : {1U, 2U, 3U}) {
            Projector truth = camera();
            truth.intrinsics.reset();
            truth.fieldOfView = degrees;
            const PoseFit fit = fitPose(pairsSeenBy(truth, 6, seed), {endoscope, std::nullopt});
            EXPECT_EQ(fit.focalLength, PartSource::Found);
            EXPECT_NEAR(fit.projector.fieldOfView, degrees, 1e-3 * degrees);
            EXPECT_LT(errorAt(fit.projector, truth), 0.1);
        }
    std::vector<LandmarkPair> noisy = pairsSeenBy(camera(), 12);
    addNoise(noisy, 1);
    const PoseFit fit = fitPose(noisy, {endoscope, std::nullopt});
    EXPECT_EQ(fit.focalLength, PartSource::Found);
    EXPECT_LT(fit.error, 5);
}

TEST(PoseFit, TakesAUsualFieldOfViewWherePairsDoNotTellIt) {
    Projector truth = camera();
    truth.intrinsics.reset();
    truth.fieldOfView = assumedFieldOfView;
    std::vector<LandmarkPair> pairs = pairsSeenBy(truth, 8);
    for (LandmarkPair& pair : pairs) { // all into one depth
        const Vector3d own = truth.pose.inverse() * pair.organ;
        pair.organ = truth.pose * Vector3d(own * (-0.3 / own.z()));
    }
    addNoise(pairs, 1);
    const PoseFit fit = fitPose(pairs, {endoscope, std::nullopt});
    EXPECT_EQ(fit.focalLength, PartSource::Assumed);
    EXPECT_EQ(fit.dominating, CameraPart::FocalLength);
    EXPECT_NEAR(fit.projector.fieldOfView, assumedFieldOfView, 15);
    EXPECT_GT(fit.eyeWithin, 0.05);
    EXPECT_EQ(fit.weaknesses, std::vector{Weakness::NearlyPlanar});
}

TEST(PoseFit, FindsThePairsThatDoNotBelong) {
    std::vector<LandmarkPair> pairs = pairsSeenBy(camera(), 10);
    addNoise(pairs, 1);
    const std::vector<std::size_t> wrong{2, 7};
    pairs[2].photo += Vector2d(60, -35);
    pairs[7].photo += Vector2d(-12, 18);
    for (const auto& intrinsics : {camera().intrinsics, std::optional<Intrinsics>()}) {
        if (!intrinsics) { // the line of sight in the middle
            Projector truth = camera();
            truth.intrinsics.reset();
            truth.fieldOfView = 30;
            pairs = pairsSeenBy(truth, 10);
            pairs[2].photo += Vector2d(60, -35);
            pairs[7].photo += Vector2d(-12, 18);
        }
        const PoseFit fit = fitPose(pairs, {endoscope, intrinsics});
        for (std::size_t i = 0; i < pairs.size(); ++i)
            EXPECT_EQ(fit.outliers[i], i == 2 || i == 7) << i << ": " << fit.errors[i];
        EXPECT_GT(fit.errors[2], 50);
        EXPECT_LT(fit.error, 2);
    }
}

TEST(PoseFit, GivesTheSameForTheSame) {
    std::vector<LandmarkPair> pairs = pairsSeenBy(camera(), 25);
    addNoise(pairs, 3);
    const PoseFit first = fitPose(pairs, {endoscope, std::nullopt}),
                  second = fitPose(pairs, {endoscope, std::nullopt});
    EXPECT_TRUE(first.projector == second.projector);
    EXPECT_EQ(first.errors, second.errors);
}

TEST(PoseFit, FitsLandmarksOfAPlane) {
    std::vector<LandmarkPair> pairs;
    for (const auto& [x, y] :
         {std::pair(-0.05, -0.04), {0.05, -0.04}, {0.04, 0.05}, {-0.05, 0.03}, {0.01, 0.0}}) {
        const Vector3d point = camera().pose * Vector3d(x, y, -0.3 - 0.5 * x);
        pairs.push_back({project(camera(), endoscope, point)->head<2>(), point});
    }
    EXPECT_LT(fitPose(pairs, {endoscope, camera().intrinsics}).error, 1e-3);
}

TEST(PoseFit, RefusesPairsThatTellNoPose) {
    const std::vector<LandmarkPair> good = pairsSeenBy(camera(), 8);
    EXPECT_THAT(poseRefusal({}), HasSubstr("0 pairs; a pose takes 4"));
    EXPECT_THAT(poseRefusal({good.begin(), good.begin() + 3}), HasSubstr("3 pairs; a pose takes 4"));
    std::vector<LandmarkPair> pairs = good;
    pairs[4].organ.y() = NAN;
    EXPECT_THAT(poseRefusal(pairs), HasSubstr("pair 5 is not finite"));
    pairs = good;
    pairs[3].photo = pairs[1].photo;
    EXPECT_THAT(poseRefusal(pairs), HasSubstr("the pairs 2 and 4 share a point"));
    pairs = good;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        pairs[i].organ = double(i) * Vector3d(0.01, 0.02, 0.005);
    EXPECT_THAT(poseRefusal(pairs), HasSubstr("on the organ lie on a line"));
    pairs = good;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        pairs[i].photo = Vector2d(100 + 30.0 * double(i), 50 + 10.0 * double(i));
    EXPECT_THAT(poseRefusal(pairs), HasSubstr("in the photo lie on a line"));
}

TEST(PoseFit, SaysThatPairsAreMirroredOrMixedUp) {
    for (const auto& intrinsics : {camera().intrinsics, std::optional<Intrinsics>()}) {
        std::vector<LandmarkPair> mirrored = pairsSeenBy(camera(), 8);
        for (LandmarkPair& pair : mirrored)
            pair.photo.x() = endoscope.width - pair.photo.x();
        EXPECT_THAT(poseRefusal(mirrored, intrinsics), HasSubstr("mirrored"));
        std::vector<LandmarkPair> mixed = pairsSeenBy(camera(), 8);
        for (std::size_t i = 0; i < mixed.size(); ++i)
            mixed[i].photo = pairsSeenBy(camera(), 8)[(i + 3) % 8].photo;
        EXPECT_THAT(poseRefusal(mixed, intrinsics), HasSubstr("no camera sees these pairs"));
    }
}
