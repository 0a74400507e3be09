#include "core/project/project_warnings.h"
#include "tests/support/test_meshes.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Springs of 2 to 5 cm.
Project ring() {
    RepairedMesh surface;
    surface.mesh = test::torus(8, 6, 0.05, 0.02);
    return makeProject("ring", surface);
}

Project withNetwork(void (*change)(SpringNetwork&)) {
    Project project = ring();
    SpringNetwork network = *project.network;
    change(network);
    project.network = std::make_shared<SpringNetwork>(network);
    return project;
}

TEST(ProjectWarnings, AreNoneOfAnOrgan) {
    EXPECT_THAT(projectWarnings(ring()), IsEmpty());
    RepairedMesh surface;
    surface.mesh = test::torus();
    EXPECT_THAT(projectWarnings(makeProject("rigid", surface, 1, {Detail::Kind::Rigid, 0})), IsEmpty());
}

TEST(ProjectWarnings, NameSpringsThatAreMuchTooLong) {
    const Project project = withNetwork([](SpringNetwork& network) { network.springs[3].restLength = 50; });
    EXPECT_THAT(projectWarnings(project),
                ElementsAre(HasSubstr("model: 1 spring with a rest length over 10 times")));
}

TEST(ProjectWarnings, LeaveSpringsAloneThatAreTenseOrHappenToBeShort) {
    const auto tense = [](SpringNetwork& network) {
        for (Spring& spring : network.springs)
            spring.restLength *= &spring == &network.springs[0] ? 0 : 9;
    };
    EXPECT_THAT(projectWarnings(withNetwork(tense)), IsEmpty());
    const auto shortOne = [](SpringNetwork& network) {
        const Spring spring = network.springs[0];
        network.restPositions[spring.second] = network.restPositions[spring.first];
    };
    EXPECT_THAT(projectWarnings(withNetwork(shortOne)), IsEmpty());
}

TEST(ProjectWarnings, NamePointsBeyondAllBounds) {
    Project project = ring();
    TriangleMesh mesh = *project.mesh;
    mesh.vertices[2].y() = -1e300;
    project.mesh = std::make_shared<TriangleMesh>(mesh);
    EXPECT_THAT(projectWarnings(project), ElementsAre(HasSubstr("mesh: 1 mesh point with a coordinate")));
}

TEST(ProjectWarnings, NameATextureWithoutSize) {
    Project project = ring();
    Atlas atlas = packAtlas(*project.mesh, {128, 1, 1});
    project.atlas = std::make_shared<Atlas>(atlas);
    EXPECT_THAT(projectWarnings(project), IsEmpty());
    atlas.texelsPerMetre = 0;
    atlas.utilisation = 1.5;
    project.atlas = std::make_shared<Atlas>(atlas);
    EXPECT_THAT(projectWarnings(project), ElementsAre(HasSubstr("texels per metre"), HasSubstr("0 to 1")));
}

} // namespace
} // namespace esm
