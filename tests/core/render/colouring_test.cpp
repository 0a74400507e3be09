#include "core/render/colouring.h"

#include "core/render/colour_ramp.h"
#include "core/render/drawn_shape.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// A ball of 0.1 m whose right half is stiffer, less viscous and heavier.
class ColouringTest : public testing::Test {
protected:
    ColouringTest() {
        TriangleMesh mesh = ball(12, 18);
        for (Vector3d& vertex : mesh.vertices)
            vertex *= 0.1;
        tissue.network = edgeNetwork(mesh);
        for (const Vector3d& node : tissue.network->restPositions) {
            const bool isRight = node.x() > 0;
            tissue.mass.push_back(isRight ? 0.002 : 0.001);
            tissue.springConstant.push_back(isRight ? 80 : 20);
            tissue.viscosity.push_back(isRight ? 1 : 3);
        }
        scene.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
        scene.network = tissue.network;
    }
    std::optional<ColourLegend> colour(ColourBy by) {
        return colourScene(scene, by, {tissue, regions, speeds}, range);
    }
    std::vector<Vector3d> scaled(double factor) const {
        std::vector<Vector3d> positions = tissue.network->restPositions;
        for (Vector3d& position : positions)
            position *= factor;
        return positions;
    }
    Paint nodePaint(const Vector3d& near) const {
        const auto& nodes = tissue.network->restPositions;
        const auto found = std::min_element(nodes.begin(), nodes.end(), [&](const auto& a, const auto& b) {
            return (a - near).norm() < (b - near).norm();
        });
        return (*scene.nodePaint)[static_cast<std::size_t>(found - nodes.begin())];
    }

    RenderScene scene;
    TissueModel tissue;
    std::vector<Region> regions;
    std::vector<double> speeds;
    std::optional<ValueRange> range;
};

Paint rampPaint(double share) {
    const Colour colour = rampColour(share);
    return {colour[0], colour[1], colour[2], 255};
}

struct Lab {
    double lightness, a, b;
};

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

/// CIELAB under D65 of linear sRGB.
Lab labOf(const Vector3d& rgb) {
    Eigen::Matrix3d toXyz;
    toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Vector3d xyz = (toXyz * rgb).cwiseQuotient(Vector3d(0.9505, 1, 1.089));
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    return {116 * f(xyz.y()) - 16, 500 * (f(xyz.x()) - f(xyz.y())), 200 * (f(xyz.y()) - f(xyz.z()))};
}

Vector3d linearRamp(double share) {
    const Colour colour = rampColour(share);
    return {linear(colour[0] / 255.0), linear(colour[1] / 255.0), linear(colour[2] / 255.0)};
}

/// Linear sRGB as those see it who lack one kind of cones (Machado, Oliveira and Fernandes 2009, severity 1).
std::vector<Eigen::Matrix3d> visions() {
    Eigen::Matrix3d protanopia, deuteranopia, tritanopia;
    protanopia << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
    deuteranopia << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    tritanopia << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
    return {Eigen::Matrix3d::Identity(), protanopia, deuteranopia, tritanopia};
}

double difference(const Lab& one, const Lab& other) {
    return std::hypot(one.lightness - other.lightness, one.a - other.a, one.b - other.b);
}

} // namespace

TEST(ColourRamp, BecomesLighterThroughoutForEveryEye) {
    for (const Eigen::Matrix3d& vision : visions()) {
        double before = -1;
        for (int step = 0; step <= 20; ++step) {
            const double lightness = labOf(vision * linearRamp(step / 20.0)).lightness;
            EXPECT_GT(lightness, before + 1) << "step " << step;
            before = lightness;
        }
    }
    EXPECT_GT(labOf(linearRamp(0)).lightness, 25) << "is seen on a dark ground";
}

TEST(ColourRamp, GoesByEvenStepsToTheEye) {
    constexpr int steps = 16;
    std::vector<double> lengths;
    for (int step = 0; step < steps; ++step)
        lengths.push_back(labOf(linearRamp((step + 1.0) / steps)).lightness -
                          labOf(linearRamp(double(step) / steps)).lightness);
    const double mean = (labOf(linearRamp(1)).lightness - labOf(linearRamp(0)).lightness) / steps;
    for (const double length : lengths)
        EXPECT_NEAR(length, mean, 0.35 * mean);
    for (const Eigen::Matrix3d& vision : visions())
        for (int step = 0; step < 8; ++step)
            EXPECT_GT(difference(labOf(vision * linearRamp(step / 8.0)),
                                 labOf(vision * linearRamp((step + 1) / 8.0))),
                      5)
                << "eighths are told apart";
}

TEST(ColourNames, AreKnownBothWays) {
    for (const ColourBy by : everyColouring)
        EXPECT_EQ(colourByFromName(nameOf(by)), by);
    EXPECT_FALSE(colourByFromName("beauty"));
}

TEST_F(ColouringTest, LegendsTellTheLeastAndTheLargestInTheirUnit) {
    struct Expected {
        ColourBy by;
        const char* unit;
        double least, largest;
    };
    for (const auto& [by, unit, least, largest] : {Expected{ColourBy::SpringConstant, "N/m", 20, 80},
                                                   {ColourBy::Viscosity, "N·s/m", 1, 3},
                                                   {ColourBy::Mass, "g", 1, 2}}) {
        const auto legend = colour(by);
        ASSERT_TRUE(legend);
        EXPECT_EQ(legend->unit, unit);
        EXPECT_DOUBLE_EQ(legend->range.minimum, least);
        EXPECT_DOUBLE_EQ(legend->range.maximum, largest);
        EXPECT_EQ(nodePaint({0.1, 0, 0}), rampPaint(by == ColourBy::Viscosity ? 0 : 1));
        EXPECT_EQ(nodePaint({-0.1, 0, 0}), rampPaint(by == ColourBy::Viscosity ? 1 : 0));
    }
}

TEST_F(ColouringTest, ByTextureTheSurfaceKeepsItsColours) {
    ASSERT_TRUE(colour(ColourBy::SpringConstant));
    ASSERT_TRUE(colour(ColourBy::Texture));
    EXPECT_EQ(scene.nodePaint, nullptr);
    EXPECT_EQ(scene.springPaint->size(), tissue.network->springs.size());
}

TEST_F(ColouringTest, OneValueEverywhereHasAColour) {
    for (const double constant : {40.0, 0.0}) {
        tissue.springConstant.assign(tissue.springConstant.size(), constant);
        const auto legend = colour(ColourBy::SpringConstant);
        EXPECT_EQ(legend->range, (ValueRange{constant, constant}));
        EXPECT_EQ(nodePaint({0, 0, 0.1}), rampPaint(std::round(0.5 * 511) / 511));
    }
}

TEST_F(ColouringTest, SpringsOfTheirOwnValuesCount) {
    tissue.ownValues = springValues(tissue);
    for (SpringValues& spring : tissue.ownValues)
        spring.springConstant = 7;
    EXPECT_EQ(colour(ColourBy::SpringConstant)->range, (ValueRange{7, 7}));
}

TEST_F(ColouringTest, StrainIsThatOfTheMovedSpringsInARangeThatNeverFalls) {
    scene.nodePositions = scaled(1.03);
    auto legend = colour(ColourBy::Strain);
    EXPECT_EQ(legend->unit, "%");
    EXPECT_EQ(legend->range, (ValueRange{0, 5})) << "the next of 1, 2, 5, 10 and so on";
    EXPECT_EQ(nodePaint({0.1, 0, 0}), rampPaint(std::round(0.6 * 511) / 511));
    scene.nodePositions = scaled(0.88);
    EXPECT_EQ(colour(ColourBy::Strain)->range.maximum, 20) << "shortening as well";
    scene.nodePositions = scaled(1.001);
    EXPECT_EQ(colour(ColourBy::Strain)->range.maximum, 20);
    range.reset();
    EXPECT_EQ(colour(ColourBy::Strain)->range.maximum, 1) << "the least";
}

TEST_F(ColouringTest, SpeedNeedsSpeeds) {
    EXPECT_FALSE(colour(ColourBy::Speed));
    EXPECT_EQ(scene.nodePaint, nullptr);
    speeds.assign(tissue.mass.size(), 0.012);
    EXPECT_EQ(colour(ColourBy::Speed)->range, (ValueRange{0, 20}));
    EXPECT_EQ(nodePaint({0.1, 0, 0}), rampPaint(std::round(0.6 * 511) / 511));
    speeds[0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(colour(ColourBy::Speed)->range, (ValueRange{0, 20})) << "what is no number has no colour";
    EXPECT_EQ((*scene.nodePaint)[0][3], 0);
}

TEST_F(ColouringTest, RegionsHaveTheirOwnColoursWhereTheyCount) {
    Region lower, upper;
    lower.name = "lower";
    lower.colour = {200, 0, 0};
    lower.ellipsoid = Ellipsoid{{0.1, 0, 0}, {0.12, 0.12, 0.12}};
    upper.name = "upper";
    upper.colour = {0, 0, 200};
    upper.ellipsoid = Ellipsoid{{0.1, 0, 0}, {0.03, 0.03, 0.03}};
    regions = {lower, upper};
    const auto legend = colour(ColourBy::Region);
    ASSERT_EQ(legend->entries.size(), 2);
    EXPECT_EQ(legend->entries[0].name, "upper") << "the one that counts first";
    EXPECT_EQ(nodePaint({0.1, 0, 0}), (Paint{0, 0, 200, 255}));
    EXPECT_EQ(nodePaint({0.07, 0.07, 0}), (Paint{200, 0, 0, 255}));
    EXPECT_EQ(nodePaint({-0.1, 0, 0})[3], 0) << "none keeps the surface's own colour";
    EXPECT_FALSE(range);
}

TEST_F(ColouringTest, DrawnVerticesMixThePaintOfTheNodesThatCarryThem) {
    colour(ColourBy::SpringConstant);
    EXPECT_EQ(vertexPaint(scene, scene.mesh->vertices.size()), *scene.nodePaint);
    EXPECT_TRUE(vertexPaint(scene, 3).empty());
    auto bound = std::make_shared<SpringNetwork>(*tissue.network);
    bound->binding.emplace();
    const std::array<std::uint32_t, 2> nodes{0, 1};
    const std::array<double, 2> shares{0.25, 0.75};
    for (std::size_t i = 0; i < scene.mesh->vertices.size(); ++i)
        bound->binding->vertices.add({nodes, shares});
    auto paint = std::vector<Paint>(tissue.mass.size(), Paint{100, 0, 40, 255});
    paint[1] = {0, 80, 40, 255};
    scene.network = bound;
    scene.nodePaint = std::make_shared<const std::vector<Paint>>(paint);
    EXPECT_EQ(vertexPaint(scene, scene.mesh->vertices.size())[5], (Paint{25, 60, 40, 255}));
}
