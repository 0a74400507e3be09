#include "core/project/project.h"
#include "core/support/errors.h"
#include "core/surface/surface_query.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>

using namespace esm;
using namespace esm::test;

namespace {

constexpr Colour blue{0, 0, 255, 255};

BrushStroke strokeAt(BrushKind kind, const Eigen::Vector3d& place) {
    BrushStroke stroke;
    stroke.kind = kind;
    stroke.radius = 0.02;
    stroke.softness = 0;
    stroke.colour = {0, 0, 255};
    stroke.path = {{place, Eigen::Vector3d::UnitZ()}};
    return stroke;
}

TextureLayer paintedLayer(std::initializer_list<BrushStroke> strokes) {
    TextureLayer layer;
    for (const BrushStroke& stroke : strokes)
        layer.strokes.push_back(std::make_shared<const BrushStroke>(stroke));
    return layer;
}

TextureLayer masked(TextureLayer layer, std::initializer_list<BrushStroke> strokes) {
    layer.strokes = paintedLayer(strokes).strokes;
    return layer;
}

/// A plate 0.1 m wide and 0.1 mm thick, its upper side first.
TriangleMesh thinPlate() {
    TriangleMesh mesh = flatSquare(0.1, 4);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::vector<Triangle> upper = mesh.triangles;
    for (std::uint32_t i = 0; i < first; ++i)
        mesh.vertices.emplace_back(mesh.vertices[i] - Eigen::Vector3d(0, 0, 1e-4));
    for (const Triangle& t : upper)
        mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
    return mesh;
}

std::vector<std::string> problemsWith(const std::function<void(BrushStroke&)>& change) {
    BrushStroke stroke = strokeAt(BrushKind::Colour, {0, 0, 0});
    change(stroke);
    return validate(stroke);
}

} // namespace

TEST(BrushStroke, CoversADiscAroundItsPointHoweverTheTextureIsPacked) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    for (const AtlasLayout layout : atlasLayouts) {
        const Atlas atlas = packAtlas(mesh, {512, 1, 2, layout});
        std::size_t texels = 0;
        onPages(mesh, atlas, {paintedLayer({strokeAt(BrushKind::Colour, {0.01, 0, 0})})},
                [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                    texels += colour == blue ? 1 : 0;
                    const double distance = (point - Eigen::Vector3d(0.01, 0, 0)).norm();
                    ASSERT_EQ(colour, distance <= 0.02 ? blue : base) << distance;
                });
        const double area = double(texels) / (atlas.texelsPerMetre * atlas.texelsPerMetre);
        EXPECT_NEAR(area / (M_PI * 0.02 * 0.02), 1, 0.02) << wordOf(layout);
    }
}

TEST(BrushStroke, FallsSoftlyAndBuildsUpNothingWhereItCrossesItself) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    BrushStroke stroke = strokeAt(BrushKind::Colour, {-0.03, 0, 0});
    stroke.softness = 0.5;
    stroke.strength = 0.5;
    stroke.path.push_back({{0.03, 0, 0}, Eigen::Vector3d::UnitZ()});
    stroke.path.push_back(stroke.path.front());
    onPages(mesh, atlas, {paintedLayer({stroke})},
            [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                const Eigen::Vector3d nearest(std::clamp(point.x(), -0.03, 0.03), 0, 0);
                const double t = std::clamp((0.02 - (point - nearest).norm()) / 0.01, 0.0, 1.0);
                ASSERT_NEAR(colour[0], 200 * (1 - 0.5 * t * t * (3 - 2 * t)), 0.51);
            });
    EXPECT_DOUBLE_EQ(strokeProfile(stroke, 0.01), 0.5);
    EXPECT_DOUBLE_EQ(strokeProfile(stroke, 0.015), 0.25);
    EXPECT_DOUBLE_EQ(strokeProfile(stroke, 0.02), 0);
}

TEST(BrushStroke, PassesFromShareToShareAlongItsPath) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    BrushStroke stroke = strokeAt(BrushKind::Colour, {-0.03, 0, 0});
    stroke.path.push_back({{0.03, 0, 0}, Eigen::Vector3d::UnitZ()});
    stroke.shares = {{1, 1}, {0.5, 0.25}};
    onPages(mesh, atlas, {paintedLayer({stroke})},
            [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                const double t = std::clamp((point.x() + 0.03) / 0.06, 0.0, 1.0);
                const Eigen::Vector3d nearest(-0.03 + 0.06 * t, 0, 0);
                const bool isPainted = (point - nearest).norm() <= 0.02 * (1 - 0.5 * t);
                ASSERT_NEAR(colour[0], 200 * (isPainted ? 0.75 * t : 1), 0.51) << point.transpose();
            });
}

TEST(BrushStroke, WithAllSharesIsTheOneWithoutAny) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    BrushStroke plain = strokeAt(BrushKind::Colour, {-0.01, 0, 0}), full = plain;
    plain.softness = full.softness = 0.7;
    full.shares = {{1, 1}};
    EXPECT_EQ(composite(mesh, atlas, {paintedLayer({plain})}, baseColour)[0].pixels,
              composite(mesh, atlas, {paintedLayer({full})}, baseColour)[0].pixels);
}

TEST(BrushStroke, DoesNotPaintThroughAThinWall) {
    const TriangleMesh mesh = thinPlate();
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    std::size_t painted = 0;
    onPages(mesh, atlas, {paintedLayer({strokeAt(BrushKind::Colour, {0, 0, 0})})},
            [&](const Eigen::Vector3d&, const Colour& colour, std::size_t triangle) {
                painted += colour == blue ? 1 : 0;
                if (triangle >= mesh.triangles.size() / 2) {
                    ASSERT_EQ(colour, base);
                }
            });
    EXPECT_GT(painted, 1000U);
}

TEST(BrushStroke, ErasesAndRestoresAPhotoInTheOrderOfPainting) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    BrushStroke restore = strokeAt(BrushKind::Restore, {0, 0, 0});
    restore.radius = 0.01;
    const TextureLayer layer =
        masked(layerFromAbove(plainPhoto(green), 0.3), {strokeAt(BrushKind::Erase, {0, 0, 0}), restore});
    onPages(mesh, atlas, {layer}, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
        const bool isErased = point.norm() <= 0.02 && point.norm() > 0.01;
        ASSERT_EQ(colour, isErased ? base : green);
    });
}

TEST(BrushStroke, PaintsAgainOverWhatWasErased) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    BrushStroke small = strokeAt(BrushKind::Colour, {0, 0, 0});
    small.radius = 0.01;
    const TextureLayer layer =
        paintedLayer({strokeAt(BrushKind::Colour, {0, 0, 0}), strokeAt(BrushKind::Erase, {0, 0, 0}), small});
    onPages(mesh, atlas, {layer}, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
        ASSERT_EQ(colour, point.norm() <= 0.01 ? blue : base);
    });
}

TEST(BrushStroke, ClonesWhatLiesBeneathItsLayer) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    BrushStroke clone = strokeAt(BrushKind::Clone, {0.02, 0.02, 0});
    clone.shift = {-0.04, -0.02, 0};
    const TextureLayer photo = layerFromAbove(checkerboard(), 0.08);
    onPages(mesh, atlas, {photo, paintedLayer({clone})},
            [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                const bool isPainted = (point - clone.path.front().place).norm() <= 0.02;
                const Eigen::Vector3d source = isPainted ? Eigen::Vector3d(point + clone.shift) : point;
                const double column = (source.x() + 0.04) / 0.01, row = (0.04 - source.y()) / 0.01;
                if (fromLine(column, row) < 2 / (0.01 * atlas.texelsPerMetre)) return;
                ASSERT_EQ(colour, colourOfSquare(column, row)) << point.transpose();
            });
}

TEST(BrushStroke, FollowsClonesOfClonesAndEndsSomewhere) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {128, 1, 2});
    const TextureLayer photo = layerFromAbove(plainPhoto(green), 0.3);
    std::vector<TextureLayer> layers{photo};
    for (int i = 0; i < 40; ++i)
        layers.push_back(paintedLayer({strokeAt(BrushKind::Clone, {0, 0, 0})}));
    // Clones of clones, as far as they are followed, take the photo's green; beyond it, what is known.
    for (const std::size_t count : {std::size_t{3}, layers.size()}) {
        const std::vector<TextureLayer> some(layers.begin(), layers.begin() + std::ptrdiff_t(count));
        forEachTexelInside(
            mesh, atlas, composite(mesh, atlas, some, baseColour),
            [&](const Eigen::Vector3d&, const Colour& colour, std::size_t) { ASSERT_EQ(colour, green); });
    }
}

TEST(BrushStroke, SaysWhatIsWrongWithIt) {
    using testing::ElementsAre;
    using testing::HasSubstr;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(problemsWith([](BrushStroke&) {}).empty());
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.radius = nan; }), ElementsAre(HasSubstr("radius")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.radius = 0; }), ElementsAre(HasSubstr("radius")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.softness = 1.1; }), ElementsAre(HasSubstr("softness")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.strength = -1; }), ElementsAre(HasSubstr("strength")));
    const auto clonesFromNowhere = [](BrushStroke& s) {
        s.kind = BrushKind::Clone;
        s.shift.x() = nan;
    };
    EXPECT_THAT(problemsWith(clonesFromNowhere), ElementsAre(HasSubstr("copied")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) {
                    s.shares = {{1, 1}, {1, 1}};
                }),
                ElementsAre(HasSubstr("as many as its points")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) {
                    s.shares = {{0.5, 1.01}};
                }),
                ElementsAre(HasSubstr("from 0 to 1")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) {
                    s.shares = {{nan, 1}};
                }),
                ElementsAre(HasSubstr("from 0 to 1")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.path.clear(); }), ElementsAre(HasSubstr("no point")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.path[0].normal.setZero(); }),
                ElementsAre(HasSubstr("direction")));
    EXPECT_THAT(problemsWith([](BrushStroke& s) { s.path[0].place.z() = nan; }),
                ElementsAre(HasSubstr("finite place")));
}

TEST(BrushStroke, LaysNoColourOnAPhotoAndBlendsInNoBandsWithoutOne) {
    using testing::ElementsAre;
    using testing::HasSubstr;
    TextureLayer photo =
        masked(layerFromAbove(plainPhoto(green), 0.3), {strokeAt(BrushKind::Colour, {0, 0, 0})});
    EXPECT_THAT(paintingProblems(photo), ElementsAre(HasSubstr("a layer of their own")));
    TextureLayer painted = paintedLayer({strokeAt(BrushKind::Colour, {0, 0, 0})});
    EXPECT_TRUE(paintingProblems(painted).empty());
    painted.blending = Blending::MultiBand;
    EXPECT_THAT(paintingProblems(painted), ElementsAre(HasSubstr("in bands")));
}
