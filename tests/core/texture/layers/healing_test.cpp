#include "core/texture/layers/healing.h"

#include "core/support/angles.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

using namespace esm;
using namespace esm::test;

namespace {

constexpr int photoSide = 1024; // pixels over 0.1 m

/// A shade that varies over the square, m.
double shadeAt(double x, double y) {
    return 128 + 900 * x - 300 * y + 8000 * x * y;
}

/// Fine stripes, of which none is as wide as what is healed.
double detailAt(double x, double y) {
    return 12 * std::sin(x / 0.0007) * std::cos(y / 0.0009);
}

constexpr double flawRadius = 0.008;
const Eigen::Vector3d flaw(0.02, 0.01, 0), toSource(-0.04, -0.02, 0);

/// Over the square from above, with a black spot.
TextureLayer flawedPhoto(bool hasDetail) {
    const auto photo = makePhoto(photoSide, photoSide, [&](int column, int row) {
        const double x = 0.1 * (column + 0.5) / photoSide - 0.05, y = 0.05 - 0.1 * (row + 0.5) / photoSide;
        const bool isFlaw = (Eigen::Vector3d(x, y, 0) - flaw).norm() < flawRadius;
        const auto value = static_cast<std::uint8_t>(
            isFlaw ? 0 : std::lround(shadeAt(x, y) + (hasDetail ? detailAt(x, y) : 0)));
        return Colour{value, value, static_cast<std::uint8_t>(value / 2), 255};
    });
    return layerFromAbove(photo, 0.1);
}

BrushStroke strokeOver(BrushKind kind, std::vector<Eigen::Vector3d> places) {
    BrushStroke stroke;
    stroke.kind = kind;
    stroke.radius = 0.012;
    stroke.softness = 0;
    stroke.shift = toSource;
    for (const Eigen::Vector3d& place : places)
        stroke.path.push_back({place, Eigen::Vector3d::UnitZ()});
    return stroke;
}

TextureLayer laidAs(const BrushStroke& stroke) {
    TextureLayer layer;
    layer.strokes = {std::make_shared<const BrushStroke>(stroke)};
    return layer;
}

/// The largest difference from the shade without a flaw, wherever the stroke lies.
double worstShade(const BrushStroke& stroke, bool onlyAtRim = false) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    double worst = 0;
    onPages(mesh, atlas, {flawedPhoto(false), laidAs(stroke)},
            [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                double nearest = 1;
                for (const BrushPoint& place : stroke.path)
                    nearest = std::min(nearest, (point - place.place).norm());
                if (nearest > 0.98 * stroke.radius || (onlyAtRim && nearest < 0.9 * stroke.radius)) return;
                worst = std::max(worst, std::abs(colour[0] - shadeAt(point.x(), point.y())));
            });
    return worst;
}

} // namespace

TEST(Healing, LeavesNoStepAtItsRimWhereACloneDoes) {
    EXPECT_GT(worstShade(strokeOver(BrushKind::Clone, {flaw}), true), 25);
    EXPECT_LT(worstShade(strokeOver(BrushKind::Heal, {flaw}), true), 2.5);
    EXPECT_LT(worstShade(strokeOver(BrushKind::Heal, {flaw})), 2.5) << "and the flaw is gone";
}

TEST(Healing, FollowsStrokesThatAreLongAndTurn) {
    const BrushStroke bent = strokeOver(BrushKind::Heal, {flaw + Eigen::Vector3d(0.005, -0.004, 0), flaw,
                                                          flaw + Eigen::Vector3d(-0.002, 0.008, 0)});
    EXPECT_LT(worstShade(bent), 4);
}

TEST(Healing, LooksAroundAStrokeAsWideAsThePenPressed) {
    const auto reachOf = [](const BrushStroke& stroke) { // along the path, from its beginning, m
        double reach = 0;
        for (const BrushPoint& place : StrokeOutline(stroke).placesAround())
            reach = std::max(reach, place.place.y() - stroke.path[0].place.y());
        return reach;
    };
    BrushStroke stroke = strokeOver(BrushKind::Heal, {flaw, flaw + Eigen::Vector3d(0, 0.006, 0)});
    EXPECT_GT(reachOf(stroke), 0.006 + stroke.radius);
    stroke.shares = {{1, 1}, {0.5, 1}};
    EXPECT_GT(reachOf(stroke), stroke.radius);
    EXPECT_LT(reachOf(stroke), 1.1 * stroke.radius);
}

TEST(Healing, KeepsTheDetailsOfItsSource) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    const BrushStroke stroke = strokeOver(BrushKind::Heal, {flaw});
    double products = 0, squares = 0, squaresOfSource = 0;
    onPages(mesh, atlas, {flawedPhoto(true), laidAs(stroke)},
            [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                if ((point - flaw).norm() > 0.9 * stroke.radius) return;
                const Eigen::Vector3d source = point + toSource;
                const double found = colour[0] - shadeAt(point.x(), point.y());
                const double wanted = detailAt(source.x(), source.y());
                products += found * wanted;
                squares += found * found;
                squaresOfSource += wanted * wanted;
            });
    EXPECT_GT(products / std::sqrt(squares * squaresOfSource), 0.95) << "the same pattern";
    EXPECT_NEAR(squares / squaresOfSource, 1, 0.15) << "as strong";
}

TEST(Healing, WithoutSurroundingsIsAClone) {
    const TriangleMesh mesh = flatSquare(0.1, 5);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    const auto pageOf = [&](BrushKind kind) {
        BrushStroke stroke = strokeOver(kind, {{0, 0, 0}});
        stroke.radius = 0.2; // more than there is
        return composite(mesh, atlas, {flawedPhoto(true), laidAs(stroke)}, baseColour)[0].pixels;
    };
    EXPECT_EQ(pageOf(BrushKind::Heal), pageOf(BrushKind::Clone));
}

TEST(Healing, IsTheMembraneWithinACircle) {
    // Harmonic functions are the real and imaginary parts of complex polynomials.
    const auto wanted = [](double x, double y) {
        return Eigen::Vector3f(float(3 + 20 * x - 7 * y), float(30 * (x * x - y * y)),
                               float(40 * (x * x * x - 3 * x * y * y)));
    };
    std::vector<HealingRim::Place> places;
    for (int i = 0; i < 200; ++i) {
        const double angle = 2 * pi * i / 200, x = std::cos(angle), y = std::sin(angle);
        places.push_back({{x, y, 0}, wanted(x, y)});
    }
    const HealingRim rim(places, 0.01);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5, 0.2}, {-0.3, 0.6}, {0.1, -0.8}})
        EXPECT_LT((rim.at({x, y, 0}) - wanted(x, y)).cwiseAbs().maxCoeff(), 0.2F) << x << ' ' << y;
}

TEST(Healing, PlacesLieOnlyBesideTheWholeStroke) {
    const BrushStroke crossed = strokeOver(
        BrushKind::Heal, {{-0.02, 0, 0}, {0.02, 0, 0}, {0.02, 0.02, 0}, {0, 0.02, 0}, {0, -0.02, 0}});
    const std::vector<BrushPoint> places = StrokeOutline(crossed).placesAround();
    EXPECT_GT(places.size(), 40U);
    EXPECT_LT(places.size(), 400U);
    for (const BrushPoint& place : places)
        for (std::size_t i = 1; i < crossed.path.size(); ++i)
            for (double t = 0; t <= 1; t += 0.01) {
                const Eigen::Vector3d on =
                    crossed.path[i - 1].place + t * (crossed.path[i].place - crossed.path[i - 1].place);
                ASSERT_GT((place.place - on).norm(), 0.93 * crossed.radius)
                    << "corners are cut by half a spacing";
            }
}
