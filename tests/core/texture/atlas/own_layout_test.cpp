#include "core/texture/atlas/own_layout.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A square of 0.1 m, cut along its diagonal.
TriangleMesh squareWith(const CornerCoordinates& first, const CornerCoordinates& second) {
    return {{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {first, second}};
}

/// It takes a quarter of the picture, twice as high as wide on it.
TriangleMesh stretchedSquare() {
    return squareWith({{{0.25, 0}, {0.5, 0}, {0.5, 1}}}, {{{0.25, 0}, {0.5, 1}, {0.25, 1}}});
}

std::string packingProblem(const TriangleMesh& mesh, AtlasOptions options = {}) {
    options.layout = AtlasLayout::Own;
    try {
        packAtlas(mesh, options);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "packed";
}

TEST(OwnLayout, HasUToTheRightAndVUp) {
    const Atlas atlas = packAtlas(stretchedSquare(), {1000, 1, 2, AtlasLayout::Own});
    EXPECT_EQ(atlas.corners[0][0], Eigen::Vector2d(250, 1000)) << "from the top left corner";
    EXPECT_EQ(atlas.corners[0][1], Eigen::Vector2d(500, 1000));
    EXPECT_EQ(atlas.corners[0][2], Eigen::Vector2d(500, 0));
    EXPECT_DOUBLE_EQ(atlas.utilisation, 0.25);
    EXPECT_DOUBLE_EQ(atlas.texelsPerMetre, 5000) << "500² texels² on 0.1² m²";
    EXPECT_EQ(seamShare(stretchedSquare(), atlas), 0);
    EXPECT_THAT(ownLayoutProblems(stretchedSquare()), IsEmpty());
    EXPECT_THAT(ownLayoutWarnings(stretchedSquare()), IsEmpty());
}

TEST(OwnLayout, TellsWhatCannotBePainted) {
    TriangleMesh bare = stretchedSquare();
    bare.textureCoordinates.clear();
    EXPECT_THAT(packingProblem(bare), HasSubstr("brought no texture coordinates"));
    EXPECT_THAT(packingProblem(squareWith({{{0, 0}, {1, 0}, {1, 1}}}, {{{1, 0}, {2, 1}, {1, 1}}})),
                HasSubstr("1 triangle whose texture coordinates leave the picture (0 to 1) (triangle 1)"));
    EXPECT_THAT(packingProblem(squareWith({{{0, 0}, {0, 0}, {0, 0}}}, {{{0, 0}, {1, 1}, {0.5, 0.5}}})),
                HasSubstr("give no triangle an area"));
    EXPECT_THAT(packingProblem(stretchedSquare(), {512, 2, 2}), HasSubstr("takes one page"));
    EXPECT_THAT(packingProblem(stretchedSquare(), {512, 1, 2, AtlasLayout::Own, 1000}),
                HasSubstr("takes one page"));
}

TEST(OwnLayout, TellsHowMuchOverlaps) {
    // Half of the second lies on the first.
    const TriangleMesh mesh = squareWith({{{0, 0}, {0.5, 0}, {0, 1}}}, {{{0, 0}, {0.5, 0}, {0.5, 1}}});
    EXPECT_THAT(packingProblem(mesh),
                HasSubstr("on 25.0 % of the area that they cover, such as triangles 0 and 1"));
    const double slip = 1e-5;
    EXPECT_THAT(ownLayoutProblems(
                    squareWith({{{0.25, 0}, {0.5 + slip, 0}, {0.5, 1}}}, {{{0.25, 0}, {0.5, 1}, {0.25, 1}}})),
                IsEmpty())
        << "rounded borders are none";
}

TEST(OwnLayout, TellsWhatCoversMoreThanThePictureWithoutLookingForIt) {
    TriangleMesh mesh = squareWith({{{0, 0}, {1, 0}, {0, 1}}}, {{{0, 0}, {1, 0}, {1, 1}}});
    mesh.triangles.push_back({0, 1, 3});
    mesh.textureCoordinates.push_back({{{0, 0}, {1, 0}, {1, 1}}});
    EXPECT_THAT(packingProblem(mesh), HasSubstr("together they cover 1.5 times the picture"));
}

TEST(OwnLayout, DoesNotTakeTrianglesWithoutAreaForMirroredOnes) {
    TriangleMesh mesh = squareWith({{{0, 0}, {0.5, 0}, {0, 0.5}}}, {{{1, 1}, {1, 1}, {1, 1}}});
    mesh.triangles.push_back({0, 1, 3});
    mesh.textureCoordinates.push_back({{{1, 0}, {1, 0}, {1, 0}}});
    EXPECT_THAT(ownLayoutWarnings(mesh), ElementsAre(HasSubstr("2 triangles without an area")));
}

TEST(OwnLayout, WarnsOfMirroredAndFlatTriangles) {
    TriangleMesh mesh = squareWith({{{0, 0}, {0.5, 0}, {0, 0.5}}}, {{{0.5, 0}, {1, 0}, {0.5, 0.5}}});
    mesh.triangles.insert(mesh.triangles.end(), {{0, 1, 3}, {1, 2, 3}});
    mesh.textureCoordinates.push_back({{{0, 0.6}, {0, 0.9}, {0.5, 0.6}}}); // the other way round
    mesh.textureCoordinates.push_back({{{1, 1}, {1, 1}, {1, 1}}});
    EXPECT_EQ(packingProblem(mesh), "packed");
    EXPECT_THAT(
        ownLayoutWarnings(mesh),
        ElementsAre(HasSubstr("1 triangle mirrored against the others in the mesh's own layout (triangle 2)"),
                    HasSubstr("1 triangle without an area in the mesh's own layout")));
    for (CornerCoordinates& places : mesh.textureCoordinates)
        for (Eigen::Vector2d& place : places)
            place.x() = 1 - place.x();
    EXPECT_THAT(ownLayoutWarnings(mesh), ElementsAre(HasSubstr("(triangle 2)"), HasSubstr("(triangle 3)")))
        << "mirrored as a whole";
}

} // namespace
} // namespace esm
