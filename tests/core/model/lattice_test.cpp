#include "core/model/lattice.h"

#include "core/geometry/triangle_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A cube of five tetrahedra, the middle one without a face at the surface.
const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                           {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
const std::vector<Tetrahedron> cube{{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};

Lattice soundLattice() {
    return {{LatticeKind::Cubic, 1}, cube, outerTriangles(cube), {1, 0.5}};
}

TEST(Lattice, HasASurfaceThatEnclosesItsTetrahedra) {
    const TriangleMesh surface{corners, outerTriangles(cube)};
    EXPECT_EQ(surface.triangles.size(), 12U);
    EXPECT_NEAR(enclosedVolume(surface), 1, 1e-12);
    double volume = 0;
    for (const Tetrahedron& tetrahedron : cube)
        volume += volumeOf(tetrahedron, corners);
    EXPECT_NEAR(volume, 1, 1e-12);
    EXPECT_THAT(surfaceNodes(soundLattice()), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST(Lattice, SaysWhatIsWrongWithIt) {
    EXPECT_THAT(validate(soundLattice(), corners, 2), IsEmpty());
    const auto problemOf = [](const auto& spoil, std::size_t springs = 2) {
        Lattice lattice = soundLattice();
        spoil(lattice);
        return validate(lattice, corners, springs);
    };
    EXPECT_THAT(problemOf([](Lattice& l) { std::swap(l.tetrahedra[3][0], l.tetrahedra[3][1]); }),
                ElementsAre(HasSubstr("1 lattice tetrahedron that is flat, turned inside out")));
    EXPECT_THAT(problemOf([](Lattice& l) {
                    l.tetrahedra[0] = {0, 1, 2, 3};
                }),
                ElementsAre(HasSubstr("(lattice tetrahedron 0)")));
    EXPECT_THAT(problemOf([](Lattice& l) { l.tetrahedra[0][2] = 8; }),
                ElementsAre(HasSubstr("without four nodes that exist")));
    EXPECT_THAT(problemOf([](Lattice& l) { l.surface[1][0] = 8; }),
                ElementsAre(HasSubstr("outer triangle with a node that does not exist")));
    EXPECT_THAT(problemOf([](Lattice& l) { l.springShares[1] = 0; }),
                ElementsAre(HasSubstr("share is not above 0")));
    EXPECT_THAT(problemOf([](Lattice&) {}, 3), ElementsAre(HasSubstr("2 of the lattice's 3 springs")));
    EXPECT_THAT(problemOf([](Lattice& l) { l.filling.spacing = 0; }), ElementsAre(HasSubstr("spacing")));
    EXPECT_THAT(problemOf([](Lattice& l) { l.tetrahedra.clear(); }), ElementsAre(HasSubstr("no tetrahedra")));
}

} // namespace
} // namespace esm
