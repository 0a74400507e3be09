#include "core/texture/projection/photo_reach.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

constexpr PhotoSize reaching{400, 200};

/// Looks down the z-axis onto a square of 0.1 m around the origin.
Projector above(ProjectorKind kind, double x) {
    Projector projector;
    projector.kind = kind;
    projector.width = 0.04;
    projector.height = 0.02;
    projector.fieldOfView = 2;
    projector.pose.translation() << x, 0, 0.5;
    return projector;
}

bool meetsSquare(const Projector& projector) {
    return mayMeet(projector, reaching, flatSquare(0.1, 3));
}

} // namespace

TEST(PhotoReach, MeetsWhatIsInSightAndMissesWhatIsBeside) {
    for (const ProjectorKind kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        EXPECT_TRUE(meetsSquare(above(kind, 0)));
        EXPECT_TRUE(meetsSquare(above(kind, 0.05))) << "half of it";
        EXPECT_FALSE(meetsSquare(above(kind, 0.2)));
        Projector turned = above(kind, 0);
        turned.pose.rotate(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
        EXPECT_FALSE(meetsSquare(turned)) << "looks away";
    }
}

TEST(PhotoReach, MeetsATriangleAllAround) {
    const TriangleMesh large{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}};
    EXPECT_TRUE(mayMeet(above(ProjectorKind::Parallel, 0), reaching, large)) << "no corner lies in the photo";
}
