#include "core/c/esm_package.h"

#include "core/exchange/package/glb.h"
#include "core/samples/samples.h"
#include "tests/core/c/opened_package.h"
#include "tests/core/exchange/export_package.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <fstream>

namespace esm {
namespace {

using testing::HasSubstr;

std::vector<double> numbers(const double* first, std::size_t count) {
    return {first, first + count};
}
std::vector<std::uint32_t> numbers(const std::uint32_t* first, std::size_t count) {
    return {first, first + count};
}

template<class Points> std::vector<double> coordinates(const Points& points) {
    std::vector<double> result;
    for (const Eigen::Vector3d& point : points)
        result.insert(result.end(), {point.x(), point.y(), point.z()});
    return result;
}
template<class Places> std::vector<std::uint32_t> corners(const Places& places) {
    std::vector<std::uint32_t> result;
    for (const auto& place : places)
        result.insert(result.end(), place.begin(), place.end());
    return result;
}

void expectSameSprings(const EsmSprings& springs, const TissueModel& tissue) {
    const std::vector<SpringValues> values = springValues(tissue);
    ASSERT_EQ(springs.count, values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Spring& spring = tissue.network->springs[i];
        EXPECT_EQ(numbers(springs.nodes + 2 * i, 2), (std::vector{spring.first, spring.second}));
        EXPECT_EQ(springs.restLengths[i], spring.restLength);
        EXPECT_EQ((SpringValues{springs.springConstants[i], springs.viscosities[i]}), values[i]);
    }
}

void expectSameNodes(const EsmModel& model, const TissueModel& tissue) {
    const std::size_t count = model.nodes.count;
    EXPECT_EQ(numbers(model.nodes.restPositions, 3 * count), coordinates(tissue.network->restPositions));
    EXPECT_EQ(numbers(model.nodes.masses, count), tissue.mass);
    EXPECT_EQ(numbers(model.nodes.springConstants, count), tissue.springConstant);
    EXPECT_EQ(numbers(model.nodes.viscosities, count), tissue.viscosity);
    EXPECT_EQ(numbers(model.fixedNodes.nodes, model.fixedNodes.count), tissue.fixedNodes);
    ASSERT_EQ(model.tethers.count, tissue.tethers.size());
    for (std::size_t i = 0; i < tissue.tethers.size(); ++i)
        EXPECT_EQ(
            (Tether{model.tethers.nodes[i], model.tethers.springConstants[i], model.tethers.viscosities[i]}),
            tissue.tethers[i]);
    ASSERT_EQ(model.hinges.count, tissue.hinges.size());
    for (std::size_t i = 0; i < tissue.hinges.size(); ++i) {
        EXPECT_EQ(numbers(model.hinges.nodes + 4 * i, 4), corners(std::vector{tissue.hinges[i].nodes}));
        EXPECT_EQ(model.hinges.stiffnesses[i], tissue.hinges[i].stiffness);
        EXPECT_EQ(model.hinges.viscosities[i], tissue.hinges[i].viscosity);
    }
}

void expectSameCarrying(const EsmModel& model, const PackagedTissue& package) {
    const SpringNetwork& network = *package.tissue.network;
    EXPECT_EQ(numbers(model.surface.restPositions, 3 * model.surface.vertexCount),
              coordinates(package.mesh.vertices));
    EXPECT_EQ(numbers(model.surface.triangles, 3 * model.surface.triangleCount),
              corners(package.mesh.triangles));
    EXPECT_EQ(numbers(model.surface.vertexNodes, model.surface.vertexCount), network.vertexNodes);
    ASSERT_EQ(model.binding.vertexCount > 0, network.binding.has_value());
    if (network.binding) {
        const BindingRows& rows = network.binding->vertices;
        EXPECT_EQ(numbers(model.binding.starts, model.binding.vertexCount + 1), rows.starts);
        EXPECT_EQ(numbers(model.binding.nodes, rows.nodes.size()), rows.nodes);
        EXPECT_EQ(numbers(model.binding.shares, rows.shares.size()), rows.shares);
        EXPECT_EQ(numbers(model.binding.triangles, 3 * model.binding.triangleCount),
                  corners(network.binding->surface));
        EXPECT_EQ(model.binding.lineCount, network.binding->lines.size());
    }
    ASSERT_EQ(model.lattice.kind != nullptr, network.lattice.has_value());
    if (network.lattice) {
        EXPECT_STREQ(model.lattice.kind, wordOf(network.lattice->filling.kind));
        EXPECT_EQ(numbers(model.lattice.tetrahedra, 4 * model.lattice.tetrahedronCount),
                  corners(network.lattice->tetrahedra));
    }
}

void expectSameModel(const EsmModel& model, const PackagedTissue& content) {
    EXPECT_EQ(model.name, content.name);
    expectSameNodes(model, content.tissue);
    expectSameSprings(model.springs, content.tissue);
    expectSameCarrying(model, content);
    EXPECT_EQ(model.stiffening.strain > 0, content.tissue.stiffening.has_value());
}

/// As the file has them, which names parts that are only pressed on elsewhere.
void expectSameFillings(const EsmFillings& fillings, const std::filesystem::path& file) {
    const auto json = parseGlb(readFile(file)).json["extensions"]["ESM_spring_mass"];
    const auto written = json.value("fillings", nlohmann::ordered_json::array());
    ASSERT_EQ(fillings.count, written.size());
    for (std::size_t i = 0; i < fillings.count; ++i) {
        EXPECT_EQ(fillings.parts[i], written[i]["part"]);
        EXPECT_EQ(fillings.stiffnesses[i], written[i]["stiffness"]);
    }
}

TEST(EsmPackage, HoldsWhatTheFileHolds) {
    std::size_t lattices = 0, bindings = 0, fillings = 0, stiffening = 0;
    for (const std::filesystem::path& file : samples("packages")) {
        SCOPED_TRACE(file);
        const OwnedPackage package = openedPackage(file);
        ASSERT_TRUE(package);
        const EsmModel& model = *esmModelOf(package.get());
        expectSameModel(model, loadPackagedTissue(file));
        expectSameFillings(model.fillings, file);
        lattices += model.lattice.tetrahedronCount;
        bindings += model.binding.vertexCount;
        fillings += model.fillings.count;
        stiffening += model.stiffening.strain > 0;
    }
    for (const std::size_t met : {lattices, bindings, fillings, stiffening})
        EXPECT_GT(met, 0U) << "no package of the tests has such a part";
}

TEST(EsmPackage, HoldsHinges) {
    Project project = makeSample("tube");
    project.base.resistsBending = true;
    const TemporaryFolder folder;
    exportPackage(project, folder / "bending.glb");
    const OwnedPackage package = openedPackage(folder / "bending.glb");
    ASSERT_TRUE(package);
    EXPECT_GT(esmModelOf(package.get())->hinges.count, 0U);
    expectSameModel(*esmModelOf(package.get()), loadPackagedTissue(folder / "bending.glb"));
}

TEST(EsmPackage, APartThatIsOnlyPressedOnIsNotFilled) {
    Glb glb = parseGlb(readFile(keptPackage("version-9-origin.glb")));
    auto& extension = glb.json["extensions"]["ESM_spring_mass"];
    extension.erase("fillings");
    extension.erase("checksums");
    const TemporaryFolder folder;
    overwrite(folder / "pressed.glb", writeGlb(glb));
    ASSERT_EQ(loadPackagedTissue(folder / "pressed.glb").tissue.cavities.size(), 1U);
    const OwnedPackage package = openedPackage(folder / "pressed.glb");
    ASSERT_TRUE(package);
    expectSameFillings(esmModelOf(package.get())->fillings, folder / "pressed.glb");
}

TEST(EsmPackage, SaysWhyAFileIsRefused) {
    const TemporaryFolder folder;
    EsmError error;
    EXPECT_EQ(esmOpenPackage((folder / "none.glb").c_str(), &error), nullptr);
    EXPECT_THAT(error.text, HasSubstr("none.glb"));
    std::ofstream(folder / "torn.glb") << "glTF";
    EXPECT_EQ(esmOpenPackage((folder / "torn.glb").c_str(), &error), nullptr);
    EXPECT_THAT(error.text, HasSubstr("binary glTF"));
    EXPECT_EQ(esmOpenPackage(nullptr, &error), nullptr);
    EXPECT_STRNE(error.text, "");
    EXPECT_EQ(esmOpenPackage(nullptr, nullptr), nullptr);
    esmFreePackage(nullptr);
}

} // namespace
} // namespace esm
