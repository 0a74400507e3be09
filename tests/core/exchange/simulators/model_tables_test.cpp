#include "core/exchange/simulators/model_tables.h"

#include "tests/support/exchange_projects.h"

#include <gmock/gmock.h>

#include <set>

namespace esm {
namespace {

/// The values of a column. Fails where there is none of them.
template<typename Value>
std::vector<Value> column(const std::vector<ModelTable>& tables, const std::string& table,
                          const std::string& name) {
    for (const ModelTable& found : tables)
        for (const TableColumn& candidate : found.columns)
            if (found.name == table && candidate.name == name)
                return std::get<std::vector<Value>>(candidate.values);
    ADD_FAILURE() << "no " << table << " " << name;
    return {};
}

std::vector<ModelTable> tablesOf(const Project& project) {
    return modelTables(handoverOf(project));
}

std::set<std::string> tableNames(const Project& project) {
    std::set<std::string> names;
    for (const ModelTable& table : tablesOf(project))
        names.insert(table.name);
    return names;
}

/// Resists bending, with fluid within that resists.
Project bladderProject() {
    Project project = richProject();
    project.base.resistsBending = true;
    project.scene.fillings = {{0, 1234.5}};
    return project;
}

TEST(ModelTables, HaveRowsOfOneLengthAndNamesOfTheirOwn) {
    for (const Project& project :
         {richProject(), filledProject(), boundProject({Detail::Kind::Nodes, 20}), bareProject(),
          boundProject({Detail::Kind::Rigid, 0}), bladderProject(), biphasicProject()}) {
        std::set<std::string> names;
        for (const ModelTable& table : tablesOf(project))
            for (const TableColumn& found : table.columns) {
                EXPECT_TRUE(names.insert(table.name + "_" + found.name).second) << found.name;
                EXPECT_EQ(rowCount(found), rowCount(table.columns.front())) << table.name << found.name;
                EXPECT_GT(rowCount(found), 0U) << table.name;
            }
    }
}

TEST(ModelTables, LeaveOutWhatTheOrganHasNoneOf) {
    EXPECT_THAT(tableNames(bareProject()), testing::ElementsAre("model", "nodes", "springs"));
    EXPECT_THAT(tableNames(richProject()),
                testing::ElementsAre("model", "nodes", "regions", "springs", "tethers", "vertices"));
    EXPECT_TRUE(tableNames(filledProject()).contains("tetrahedra"));
    EXPECT_TRUE(tableNames(boundProject({Detail::Kind::Rigid, 0})).contains("lines"));
}

TEST(ModelTables, HoldHingesAndFluidsToTheLastBit) {
    const Project project = bladderProject();
    const TissueModel tissue = evaluateModel(project);
    const std::vector<ModelTable> tables = tablesOf(project);
    const auto nodes = column<std::int32_t>(tables, "hinges", "nodes");
    const auto stiffness = column<double>(tables, "hinges", "stiffness");
    ASSERT_FALSE(tissue.hinges.empty());
    ASSERT_EQ(stiffness.size(), tissue.hinges.size());
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        EXPECT_EQ(stiffness[i], tissue.hinges[i].stiffness);
        for (std::size_t corner = 0; corner < 4; ++corner)
            EXPECT_EQ(static_cast<std::uint32_t>(nodes[4 * i + corner]), tissue.hinges[i].nodes[corner]);
    }
    EXPECT_THAT(column<double>(tables, "fillings", "stiffness"), testing::ElementsAre(1234.5));
    TriangleMesh fluid{tissue.network->restPositions, {}};
    const auto corners = column<std::int32_t>(tables, "filling_triangles", "nodes");
    for (std::size_t i = 0; i < corners.size(); i += 3)
        fluid.triangles.push_back({static_cast<std::uint32_t>(corners[i]),
                                   static_cast<std::uint32_t>(corners[i + 1]),
                                   static_cast<std::uint32_t>(corners[i + 2])});
    EXPECT_NEAR(enclosedVolume(fluid), enclosedVolume(*project.mesh), 1e-12);
}

TEST(ModelTables, SayHowNodesCarryEachVertex) {
    const Project project = boundProject({Detail::Kind::Nodes, 20});
    const std::vector<ModelTable> tables = tablesOf(project);
    const auto vertices = column<std::int32_t>(tables, "binding", "vertex");
    const auto shares = column<double>(tables, "binding", "share");
    std::vector<double> sums(project.mesh->vertices.size(), 0);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        sums[static_cast<std::size_t>(vertices[i])] += shares[i];
    for (const double whole : sums)
        EXPECT_NEAR(whole, 1, 1e-12);
    EXPECT_EQ(column<std::int32_t>(tables, "simulated_triangles", "nodes").size(),
              3 * project.network->binding->surface.size());
}

TEST(ModelTables, SayWhatTheWholeIs) {
    Project project = biphasicProject();
    const std::vector<ModelTable> tables = tablesOf(project);
    EXPECT_THAT(column<std::string>(tables, "model", "name"), testing::ElementsAre(project.name));
    EXPECT_THAT(column<std::string>(tables, "model", "damping"), testing::ElementsAre("isotropic"));
    EXPECT_THAT(column<std::string>(tables, "model", "integrator"), testing::ElementsAre("rk4"));
    EXPECT_THAT(column<double>(tables, "model", "stiffening_factor"), testing::ElementsAre(1e3 / 7));
    EXPECT_EQ(column<double>(tables, "nodes", "mass"), evaluateModel(project).mass);
}

TEST(ModelTables, GiveANodeTheLastRegionThatItBelongsToByHalf) {
    Project project = bareProject();
    Region whole, sharp, soft;
    sharp.ellipsoid = Ellipsoid{{0, 0, 0}, {0.015, 0.01, 0.01}, Eigen::Quaterniond::Identity()};
    soft.ellipsoid = Ellipsoid{{0.07, 0, 0}, {0.005, 0.01, 0.01}, Eigen::Quaterniond::Identity()};
    soft.rim = 0.018; // 0.06 lies within the first half of it, 0.05 beyond
    EXPECT_THAT(regionsOfNodes(*project.network, {whole, sharp, soft}),
                testing::ElementsAre(1, 1, 0, 0, 0, 0, 2, 2));
    EXPECT_THAT(regionsOfNodes(*project.network, {sharp}),
                testing::ElementsAre(0, 0, -1, -1, -1, -1, -1, -1));
}

} // namespace
} // namespace esm
