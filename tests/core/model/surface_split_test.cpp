#include "core/model/surface_split.h"

#include "core/geometry/adjacency.h"
#include "core/model/net_elasticity.h"
#include "core/model/wall_hinges.h"
#include "core/support/errors.h"
#include "tests/support/split_tissue.h"

#include <gmock/gmock.h>

#include <numeric>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tissue::pathAlong;
using tissue::Sheet;
using tissue::sheetOf;
using tissue::SplitPath;
using tissue::splitSheet;

/// Five by five nodes in the x-y plane, seen from above.
Sheet grid() {
    return sheetOf(tissue::gridMesh(5, 0.1));
}

std::vector<std::uint32_t> twinsOf(const SplitTissue& split) {
    std::vector<std::uint32_t> nodes;
    for (const PartedNode& parted : split.parted)
        nodes.push_back(parted.node);
    return nodes;
}

std::size_t partsOf(const SplitTissue& split) {
    const TriangleMesh& mesh = *split.topology.surface;
    return connectedParts(mesh.triangles, mesh.vertices.size()).count;
}

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Springs and triangles join the same nodes, and every drawn vertex lies at its node.
void expectSound(const SplitTissue& split) {
    EXPECT_THAT(validate(split.tissue), IsEmpty());
    EXPECT_THAT(carryingProblems(*split.topology.surface, *split.topology.network), IsEmpty());
    EXPECT_EQ(split.topology.network, split.tissue.network);
    EXPECT_THAT(split.map.problems(split.tissue.mass.size() - split.parted.size(), split.tissue.mass.size()),
                IsEmpty());
    const SpringNetwork& network = *split.topology.network;
    const TriangleMesh& mesh = *split.topology.surface;
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex)
        EXPECT_EQ(mesh.vertices[vertex], network.restPositions[network.vertexNodes[vertex]]);
    std::vector<Edge> springs;
    for (const Spring& spring : network.springs)
        springs.push_back(std::minmax(spring.first, spring.second));
    EXPECT_THAT(springs, testing::UnorderedElementsAreArray(uniqueEdges(simulatedSurface(mesh, network))));
}

// A hinge keeps its two triangles, or is gone: those of the parted surface have all that is left.
TEST(SurfaceSplit, TakesAwayTheHingesAlongThePathAlone) {
    for (const std::vector<std::uint32_t>& nodes :
         {std::vector<std::uint32_t>{2, 7, 12, 17, 22}, {7, 12, 17}, {6, 7, 12, 11, 6}, {0, 6, 12, 13}}) {
        Sheet sheet = grid();
        const auto hingesOf = [](const Sheet& of) {
            return wallHinges(of.tissue, simulatedSurface(*of.topology.surface, *of.topology.network), 0.003);
        };
        sheet.tissue.hinges = hingesOf(sheet);
        const SplitTissue split = splitSheet(sheet, pathAlong(nodes));
        expectSound(split);
        const auto asNodes = [](const std::vector<Hinge>& hinges) {
            std::vector<std::array<std::uint32_t, 4>> sorted;
            for (auto [corners, stiffness, viscosity] : hinges) {
                std::sort(corners.begin(), corners.begin() + 2);
                std::sort(corners.begin() + 2, corners.end());
                sorted.push_back(corners);
            }
            return sorted;
        };
        EXPECT_THAT(asNodes(split.tissue.hinges),
                    testing::UnorderedElementsAreArray(asNodes(hingesOf({split.topology, split.tissue}))));
        EXPECT_EQ(split.tissue.hinges.size(), sheet.tissue.hinges.size() - (nodes.size() - 1));
    }
}

TEST(SurfaceSplit, FromBorderToBorderMakesTwoParts) {
    const Sheet sheet = grid();
    const SplitTissue split = splitSheet(sheet, pathAlong({2, 7, 12, 17, 22}));
    expectSound(split);
    EXPECT_EQ(partsOf(split), 2U);
    EXPECT_THAT(twinsOf(split), ElementsAre(2, 7, 12, 17, 22));
    EXPECT_EQ(split.parted.front().twin, 25U);
    EXPECT_EQ(split.parted.back().twin, 29U);
    EXPECT_EQ(split.topology.origin.back(), 22U);
    const TriangleMesh& mesh = *split.topology.surface;
    for (const Triangle& t : mesh.triangles) {
        const bool isLeft = mesh.vertices[t[0]].x() + mesh.vertices[t[1]].x() + mesh.vertices[t[2]].x() < 0;
        for (const std::uint32_t corner : t) {
            const bool isTwin = corner >= 25, isParted = isTwin || corner % 5 == 2;
            EXPECT_TRUE(!isParted || isTwin != isLeft) << "what lies on the left keeps its numbers";
        }
    }
}

TEST(SurfaceSplit, TellsWhereNodesAndTrianglesCameFrom) {
    const TriangleMesh authored = tissue::gridMesh(5, 0.1);
    const SplitTissue split = splitSheet(grid(), pathAlong({2, 7, 12, 17, 22}));
    std::vector<Triangle> triangles = split.topology.surface->triangles;
    for (Triangle& triangle : triangles)
        for (std::uint32_t& node : triangle)
            node = split.topology.origin[node];
    EXPECT_EQ(triangles, authored.triangles);
}

TEST(SurfaceSplit, TheOtherWayTheOtherSideKeepsItsNumbers) {
    const SplitTissue split = splitSheet(grid(), pathAlong({22, 17, 12, 7, 2}));
    expectSound(split);
    EXPECT_THAT(twinsOf(split), ElementsAre(22, 17, 12, 7, 2));
    const Triangle& mostLeft = split.topology.surface->triangles[2];
    EXPECT_GE(*std::max_element(mostLeft.begin(), mostLeft.end()), 25U);
}

TEST(SurfaceSplit, KeepsMassAndStiffness) {
    const Sheet sheet = grid();
    for (const SplitPath& path : {pathAlong({2, 7, 12, 17, 22}), pathAlong({6, 7, 13, 18, 17, 11, 6}),
                                  pathAlong({2, 7, 12}), pathAlong({7, 12, 17})}) {
        const SplitTissue split = splitSheet(sheet, path);
        expectSound(split);
        EXPECT_NEAR(sum(split.tissue.mass), sum(sheet.tissue.mass), 1e-15);
        double before = 0, after = 0, viscosityBefore = 0, viscosityAfter = 0;
        for (const auto& [springConstant, viscosity] : springValues(sheet.tissue)) {
            before += springConstant;
            viscosityBefore += viscosity;
        }
        for (const auto& [springConstant, viscosity] : springValues(split.tissue)) {
            after += springConstant;
            viscosityAfter += viscosity;
        }
        EXPECT_NEAR(after, before, 1e-12 * before);
        EXPECT_NEAR(viscosityAfter, viscosityBefore, 1e-12 * viscosityBefore);
        EXPECT_TRUE(hasOwnValues(split.tissue));
    }
}

TEST(SurfaceSplit, PartsTheSharesOfAnEvenSheet) {
    Sheet sheet = grid();
    auto network = std::make_shared<SpringNetwork>(*sheet.topology.network);
    network->sheet = sheetShares(network->restPositions, network->springs, sheet.topology.surface->triangles);
    sheet.topology.network = sheet.tissue.network = network;
    for (const double share : network->sheet->springs)
        sheet.tissue.ownValues.push_back({12 * share, 3 * share});
    const SplitTissue split = splitSheet(sheet, pathAlong({2, 7, 12, 17, 22}));
    expectSound(split);
    const SheetShares& shares = *split.topology.network->sheet;
    EXPECT_NEAR(sum(shares.nodes), sum(network->sheet->nodes), 1e-12);
    EXPECT_NEAR(shares.nodes[25], split.parted[0].twinShare * network->sheet->nodes[2], 1e-15);
    for (std::size_t i = 0; i < shares.springs.size(); ++i)
        EXPECT_NEAR(split.tissue.ownValues[i].springConstant, 12 * shares.springs[i], 1e-12) << i;
}

TEST(SurfaceSplit, SharesMassAndTethersByTheAreaAtRest) {
    Sheet sheet = grid();
    sheet.tissue.tethers = {{12, 6, 3}, {3, 1, 1}, {12, 1, 0}};
    sheet.tissue.fixedNodes = {2, 7};
    const SplitTissue split = splitSheet(sheet, pathAlong({2, 7, 12}));
    ASSERT_THAT(twinsOf(split), ElementsAre(2, 7)) << "the end inside stays one";
    EXPECT_THAT(split.tissue.fixedNodes, ElementsAre(2, 7, 25, 26));
    EXPECT_EQ(split.tissue.tethers.size(), 3U);
    const SplitTissue other = splitSheet(sheet, pathAlong({12, 7, 2}));
    EXPECT_THAT(twinsOf(other), ElementsAre(7, 2));
    // On the right of 2 lies one triangle of three, since the diagonals go up and to the right.
    EXPECT_NEAR(split.parted[0].twinShare, 2.0 / 3, 1e-12);
    EXPECT_NEAR(split.tissue.mass[25], 2.0 / 3 * sheet.tissue.mass[2], 1e-15);
    EXPECT_NEAR(other.parted[1].twinShare, 1.0 / 3, 1e-12);
    const SplitTissue across = splitSheet(sheet, pathAlong({7, 12, 18}));
    ASSERT_THAT(twinsOf(across), ElementsAre(12));
    ASSERT_EQ(across.tissue.tethers.size(), 5U);
    const double share = across.parted[0].twinShare;
    EXPECT_NEAR(share, 1.0 / 3, 1e-12);
    EXPECT_EQ(across.tissue.tethers[3].node, 25U);
    EXPECT_NEAR(across.tissue.tethers[3].springConstant, 6 * share, 1e-12);
    EXPECT_NEAR(across.tissue.tethers[0].springConstant, 6 * (1 - share), 1e-12);
    EXPECT_NEAR(across.tissue.tethers[0].viscosity + across.tissue.tethers[3].viscosity, 3, 1e-12);
    EXPECT_EQ(across.tissue.tethers[1].springConstant, 1);
}

TEST(SurfaceSplit, ALoopCutsOutWhatItGoesRound) {
    const SplitTissue split = splitSheet(grid(), pathAlong({6, 7, 13, 18, 17, 11, 6}));
    EXPECT_EQ(partsOf(split), 2U);
    EXPECT_THAT(twinsOf(split), ElementsAre(6, 7, 13, 18, 17, 11));
    const Sheet ball = sheetOf(tissue::sphereMesh(2, 0.05));
    const Triangle& triangle = ball.topology.surface->triangles[17];
    const SplitTissue window =
        splitSheet(ball, pathAlong({triangle[0], triangle[1], triangle[2], triangle[0]}));
    expectSound(window);
    EXPECT_EQ(partsOf(window), 2U);
}

TEST(SurfaceSplit, InsideOpensASlit) {
    const SplitTissue split = splitSheet(grid(), pathAlong({6, 12, 18}));
    expectSound(split);
    EXPECT_EQ(partsOf(split), 1U);
    EXPECT_THAT(twinsOf(split), ElementsAre(12));
    EXPECT_EQ(countEdges(sidesByEdge(split.topology.surface->triangles)).boundary, 16 + 4U);
}

TEST(SurfaceSplit, GoesOnInWhatIsSplitAlready) {
    const SplitTissue first = splitSheet(grid(), pathAlong({2, 7, 12, 17, 22}));
    const Sheet halves{first.topology, first.tissue};
    const SplitTissue second = splitSheet(halves, pathAlong({10, 11, 12}));
    expectSound(second);
    EXPECT_EQ(partsOf(second), 3U);
    const SplitTissue third = splitSheet({second.topology, second.tissue}, pathAlong({27, 13, 14}));
    expectSound(third);
    EXPECT_EQ(partsOf(third), 4U);
    EXPECT_EQ(third.topology.origin[third.parted[0].twin], 12U);
}

TEST(SurfaceSplit, DrawsEveryVertexOfAPartedNodeOnItsSide) {
    Sheet sheet = grid();
    TriangleMesh mesh = *sheet.topology.surface;
    auto network = std::make_shared<SpringNetwork>(*sheet.tissue.network);
    // As with a seam of a texture: node 12 is drawn by two vertices.
    mesh.vertices.push_back(Eigen::Vector3d(mesh.vertices[12]));
    network->vertexNodes.push_back(12);
    std::size_t turned = 0;
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle)
            if (corner == 12 && turned++ % 2 == 0) corner = 25;
    sheet.tissue.network = network;
    sheet.topology = authoredTopology(std::make_shared<const TriangleMesh>(mesh), network);
    const SplitTissue split = splitSheet(sheet, pathAlong({2, 7, 12, 17, 22}));
    expectSound(split);
    EXPECT_EQ(split.tissue.mass.size(), 30U);
    EXPECT_EQ(split.topology.surface->vertices.size(), 26 + 6U);
    EXPECT_EQ(partsOf(split), 2U);
}

struct Refusal {
    const char* name;
    SplitPath path;
    const char* words;
};

TEST(SurfaceSplit, RefusesWhatIsNoPathWithWords) {
    const Refusal refusals[] = {
        {"nothing", {}, "no edge is named"},
        {"one inner edge", pathAlong({7, 12}), "parts nothing by itself"},
        {"no edge", pathAlong({2, 8, 12}), "no edge of the surface"},
        {"far apart", pathAlong({2, 22}), "2-22 is no edge of the surface"},
        {"missing node", pathAlong({2, 7, 99}), "there is no node 99 then; the last is 24"},
        {"not in order", {{2, 7}, {12, 17}}, "edge 1 begins at node 12, not where the edge before it ends"},
        {"a branch", pathAlong({2, 7, 12, 13, 7}), "comes to node 7 twice"},
        {"there and back", pathAlong({7, 12, 7}), "comes to node 7 twice"},
        {"in place", pathAlong({7, 7}), "comes to node 7 twice"},
        {"along the border", pathAlong({1, 2, 7}), "the edge 1-2 lies on the border"},
        {"by the border", pathAlong({11, 10, 16}), "touches the border at node 10"},
        {"by the border, turned", pathAlong({16, 10, 11}), "touches the border at node 10"},
    };
    for (const auto& [name, path, words] : refusals) {
        SCOPED_TRACE(name);
        try {
            splitSheet(grid(), path);
            ADD_FAILURE() << "is no path";
        } catch (const InvalidModel& error) {
            EXPECT_THAT(error.what(), HasSubstr(words));
        }
    }
}

std::string refusalOf(const Sheet& sheet, const SplitPath& path) {
    try {
        splitSheet(sheet, path);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "was split";
}

TEST(SurfaceSplit, RefusesSurfacesWithoutTwoSides) {
    TriangleMesh mesh = tissue::gridMesh(5, 0.1);
    mesh.vertices.emplace_back(0, 0, 0.1);
    mesh.triangles.push_back({7, 12, 25});
    EXPECT_THAT(refusalOf(sheetOf(mesh), pathAlong({2, 7, 12})), HasSubstr("more than two triangles meet"));
    mesh = tissue::gridMesh(5, 0.1);
    std::swap(mesh.triangles[10][0], mesh.triangles[10][1]);
    const Triangle& turned = mesh.triangles[10];
    EXPECT_THAT(refusalOf(sheetOf(mesh), pathAlong({turned[0], turned[1], turned[2], turned[0]})),
                HasSubstr("do not agree which side is outside"));
}

TEST(SurfaceSplit, RefusesNetworksThatAreNotTheSurface) {
    Sheet sheet = grid();
    auto network = std::make_shared<SpringNetwork>(*sheet.tissue.network);
    network->springs.push_back({12, 4, 0.1});
    sheet.topology.network = sheet.tissue.network = network;
    EXPECT_THAT(refusalOf(sheet, pathAlong({7, 12, 17})),
                HasSubstr("the spring from node 12 to node 4 is no edge of the surface"));
    EXPECT_EQ(refusalOf(sheet, pathAlong({6, 7, 8})), "was split") << "of other nodes it does no harm";
    network = std::make_shared<SpringNetwork>(*grid().tissue.network);
    network->binding = bindToLine(25, {0, 1});
    sheet.topology.network = sheet.tissue.network = network;
    EXPECT_THAT(refusalOf(sheet, pathAlong({7, 12, 17})), HasSubstr("fewer nodes carry the surface"));
}

TEST(SurfaceSplit, RefusesSidesWithoutArea) {
    TriangleMesh mesh = tissue::gridMesh(3, 0.1);
    for (const std::size_t node : {2U, 5U, 8U})
        mesh.vertices[node].x() = 0;
    EXPECT_THAT(refusalOf(sheetOf(mesh), pathAlong({1, 4, 7})), HasSubstr("have no area to share"));
}

} // namespace
} // namespace esm
