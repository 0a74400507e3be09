#include "core/model/cavity.h"
#include "core/model/tissue_model.h"
#include "core/support/errors.h"
#include "tests/support/filled_ball.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace esm;
using testing::HasSubstr;

namespace {

/// A ball and, behind it in the list of triangles, a smaller one beside it.
TriangleMesh twoBalls() {
    TriangleMesh mesh = tissue::sphereMesh(1, 1);
    const TriangleMesh other = tissue::sphereMesh(1, 0.5);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : other.vertices)
        mesh.vertices.emplace_back(vertex + Eigen::Vector3d(4, 0, 0));
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({a + first, b + first, c + first});
    return mesh;
}

std::string cavityRefusal(const TriangleMesh& mesh, std::uint32_t part) {
    try {
        cavityOf(mesh.vertices, mesh.triangles, part);
    } catch (const InvalidModel& refused) {
        return refused.what();
    }
    return {};
}

} // namespace

TEST(Cavity, IsOneOfTheParts) {
    const TriangleMesh mesh = twoBalls();
    for (const std::uint32_t part : {0U, 1U}) {
        const Cavity cavity = cavityOf(mesh.vertices, mesh.triangles, part);
        EXPECT_EQ(cavity.part, part);
        EXPECT_NEAR(enclosedVolume({mesh.vertices, cavity.triangles}),
                    enclosedVolume(tissue::sphereMesh(1, part == 0 ? 1 : 0.5)), 1e-12);
        EXPECT_TRUE(validate(cavity, mesh.vertices).empty());
    }
}

TEST(Cavity, FacesOutwardsWhicheverWayTheSurfaceDoes) {
    TriangleMesh mesh = tissue::sphereMesh(1, 1);
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_GT(enclosedVolume({mesh.vertices, cavityOf(mesh.vertices, mesh.triangles, 0).triangles}), 3.5);
}

TEST(Cavity, IsRefusedWhereNoFluidWouldStay) {
    EXPECT_THAT(cavityRefusal(twoBalls(), 2), HasSubstr("no part 2"));
    EXPECT_THAT(cavityRefusal(twoBalls(), 2), HasSubstr("it has 2"));
    EXPECT_THAT(cavityRefusal({}, 0), HasSubstr("it has none"));

    TriangleMesh open = twoBalls();
    open.triangles.pop_back();
    EXPECT_EQ(cavityRefusal(open, 0), "");
    EXPECT_THAT(cavityRefusal(open, 1), HasSubstr("part 1 of the surface is open"));
    EXPECT_THAT(cavityRefusal(open, 1),
                HasSubstr("3 open edges in 1 borders, the longest of 3 edges, near ("));

    TriangleMesh turned = twoBalls();
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    EXPECT_THAT(cavityRefusal(turned, 0), HasSubstr("at 3 edges it turns its inside out"));

    TriangleMesh flat = tissue::sphereMesh(1, 1);
    for (Eigen::Vector3d& vertex : flat.vertices)
        vertex.z() = 0;
    EXPECT_THAT(cavityRefusal(flat, 0), HasSubstr("encloses nothing"));
}

TEST(Cavity, IsPartOfATissuesProblems) {
    TissueModel model = tissue::filledBall(1, {}, {1000, 10});
    EXPECT_TRUE(validate(model).empty());
    for (const double wrong : {-1.0, 2e30, std::nan("")}) {
        TissueModel other = model;
        other.cavities[0].stiffness = wrong;
        EXPECT_EQ(validate(other).size(), 1U) << wrong;
        other = model;
        other.cavities[0].largestPressure = wrong;
        EXPECT_EQ(validate(other).size(), 1U) << wrong;
    }
    for (const double wrong : {10.5, -11.0, std::nan("")}) {
        TissueModel other = model;
        other.cavities[0].initialPressure = wrong;
        EXPECT_THAT(validate(other), testing::ElementsAre(HasSubstr("beyond the largest, 10 Pa"))) << wrong;
    }
    TissueModel missing = model;
    missing.cavities[0].triangles[3][1] = 1000;
    EXPECT_THAT(validate(missing), testing::ElementsAre(HasSubstr("nodes that do not exist")));
    TissueModel inward = model;
    for (Triangle& triangle : inward.cavities[0].triangles)
        std::swap(triangle[0], triangle[1]);
    EXPECT_THAT(validate(inward), testing::ElementsAre(HasSubstr("faces into its fluid")));
    TissueModel twice = model;
    twice.cavities.push_back(twice.cavities[0]);
    EXPECT_THAT(validate(twice), testing::ElementsAre(HasSubstr("filled twice")));
}
