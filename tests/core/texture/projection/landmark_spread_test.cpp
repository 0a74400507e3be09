#include "core/texture/projection/landmark_spread.h"

#include "tests/core/texture/projection/seen_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::vector<Weakness> weaknessesOfAll(const std::vector<LandmarkPair>& pairs) {
    return weaknessesOf(pairs, std::vector<bool>(pairs.size(), true), diagonal);
}

/// Landmarks whose places in space are `flattened` ones of those that the camera sees.
template<typename Flattened> std::vector<LandmarkPair> seenPairs(const Flattened& flattened) {
    std::vector<LandmarkPair> pairs;
    for (const LandmarkPair& pair : pairsSeenBy(camera(), 10)) {
        const Eigen::Vector3d own = flattened(camera().pose.inverse() * pair.organ);
        const Eigen::Vector3d organ = camera().pose * own;
        pairs.push_back({project(camera(), endoscope, organ)->head<2>(), organ});
    }
    return pairs;
}

} // namespace

TEST(LandmarkSpread, FindsNothingWrongWithLandmarksAllOver) {
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U})
        EXPECT_THAT(weaknessesOfAll(pairsSeenBy(camera(), 10, seed)), IsEmpty()) << seed;
}

TEST(LandmarkSpread, NamesANearPlane) {
    EXPECT_THAT(weaknessesOfAll(seenPairs([](const Eigen::Vector3d& own) -> Eigen::Vector3d {
                    return {own.x(), own.y(), -0.3 - 0.4 * own.x() + 0.02 * (own.z() + 0.3)};
                })),
                ElementsAre(Weakness::NearlyPlanar));
}

TEST(LandmarkSpread, NamesANearLine) {
    EXPECT_THAT(weaknessesOfAll(seenPairs([](const Eigen::Vector3d& own) -> Eigen::Vector3d {
                    return {own.x(), 0.5 * own.x() + 0.03 * own.y(), -0.3 + 0.03 * own.y()};
                })),
                ElementsAre(Weakness::NearlyOnALine));
}

TEST(LandmarkSpread, NamesLandmarksInACornerOfThePhoto) {
    EXPECT_THAT(weaknessesOfAll(seenPairs([](const Eigen::Vector3d& own) -> Eigen::Vector3d {
                    return Eigen::Vector3d(0.03, 0.02, -0.3) + 0.1 * (own + Eigen::Vector3d(0, 0, 0.3));
                })),
                ElementsAre(Weakness::CloseTogether));
}

TEST(LandmarkSpread, LeavesOutPairsThatDoNotCount) {
    std::vector<LandmarkPair> pairs = seenPairs([](const Eigen::Vector3d& own) -> Eigen::Vector3d {
        return {own.x(), own.y(), -0.3};
    });
    pairs[4].organ += camera().pose.linear() * Eigen::Vector3d(0, 0, 0.2);
    EXPECT_THAT(weaknessesOfAll(pairs), IsEmpty());
    std::vector<bool> counts(pairs.size(), true);
    counts[4] = false;
    EXPECT_THAT(weaknessesOf(pairs, counts, diagonal), ElementsAre(Weakness::NearlyPlanar));
}
