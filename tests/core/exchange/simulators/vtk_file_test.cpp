#include "core/exchange/simulators/vtk_file.h"

#include "core/exchange/simulators/exporters.h"
#include "core/support/byte_order.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <numeric>
#include <regex>

namespace esm {
namespace {

/// A reader of the few things that a file of ours holds, sharing nothing with what wrote it.
class VtpText {
public:
    explicit VtpText(const std::filesystem::path& file) : m_bytes(readFile(file)) {
        m_text.assign(m_bytes.begin(), m_bytes.end());
        m_appended = m_text.find("<AppendedData encoding=\"raw\">");
        m_appended = m_text.find('_', m_appended) + 1;
    }

    std::size_t count(const std::string& name) const {
        std::smatch match;
        std::regex_search(m_text, match, std::regex("NumberOf" + name + "=\"([0-9]+)\""));
        return std::stoul(match[1]);
    }

    bool contains(const std::string& text) const { return m_text.find(text) != m_text.npos; }

    /// The numbers of an array within an element such as PointData.
    template<typename Number>
    std::vector<Number> numbers(const std::string& element, const std::string& name) const {
        const std::size_t begin = m_text.find("<" + element),
                          place = m_text.find("Name=\"" + name + '"', begin);
        EXPECT_LT(place, m_text.find("</" + element, begin)) << element << " " << name;
        const std::size_t offset = m_text.find("offset=\"", place) + 8;
        const std::uint8_t* array = &m_bytes[m_appended + std::stoul(m_text.substr(offset))];
        std::vector<Number> values(littleEndian<std::uint64_t>(array) / sizeof(Number));
        std::memcpy(values.data(), array + 8, values.size() * sizeof(Number));
        return values;
    }

private:
    Bytes m_bytes;
    std::string m_text;
    std::size_t m_appended = 0;
};

class VtkFile : public testing::Test {
protected:
    VtpText exported(const Project& project) const { return exported(project, m_file); }
    VtpText exported(const Project& project, const std::filesystem::path& file) const {
        exportProject(project, exporterFor(file), file);
        return VtpText(file);
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.vtp";
};

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST_F(VtkFile, HoldsSpringsAndTheirTissueToTheLastBit) {
    const Project project = richProject();
    const TissueModel tissue = evaluateModel(project);
    const VtpText file = exported(project);
    ASSERT_EQ(file.count("Lines"), tissue.network->springs.size());
    ASSERT_EQ(file.count("Polys"), project.mesh->triangles.size());
    const auto ends = file.numbers<std::int64_t>("Lines", "connectivity");
    const auto constants = file.numbers<double>("CellData", "spring_constant");
    const auto viscosities = file.numbers<double>("CellData", "viscosity");
    const auto lengths = file.numbers<double>("CellData", "rest_length");
    ASSERT_EQ(constants.size(), file.count("Lines") + file.count("Polys"));
    for (std::size_t i = 0; i < tissue.network->springs.size(); ++i) {
        const Spring& spring = tissue.network->springs[i];
        EXPECT_EQ(ends[2 * i], spring.first);
        EXPECT_EQ(ends[2 * i + 1], spring.second);
        EXPECT_EQ(constants[i], valuesOf(tissue, i).springConstant);
        EXPECT_EQ(viscosities[i], valuesOf(tissue, i).viscosity);
        EXPECT_EQ(lengths[i], spring.restLength);
    }
}

TEST_F(VtkFile, HoldsNodesAsPoints) {
    const Project project = richProject();
    const TissueModel tissue = evaluateModel(project);
    const VtpText file = exported(project);
    const auto places = file.numbers<double>("Points", "Points");
    ASSERT_EQ(places.size(), 3 * file.count("Points"));
    for (std::size_t i = 0; i < tissue.mass.size(); ++i)
        EXPECT_EQ(places[3 * i], tissue.network->restPositions[i].x());
    const auto mass = file.numbers<double>("PointData", "mass");
    EXPECT_DOUBLE_EQ(sum(mass), sum(tissue.mass));
    const auto fixed = file.numbers<std::uint8_t>("PointData", "fixed");
    EXPECT_EQ(static_cast<std::size_t>(std::accumulate(fixed.begin(), fixed.end(), 0)),
              tissue.fixedNodes.size());
    double tethers = 0;
    for (const Tether& tether : tissue.tethers)
        tethers += tether.springConstant;
    EXPECT_NEAR(sum(file.numbers<double>("PointData", "tether_spring_constant")), tethers, 1e-9 * tethers);
}

TEST_F(VtkFile, DrawsTheSurfaceThatFewerNodesCarry) {
    const Project project = boundProject({Detail::Kind::Nodes, 20});
    const VtpText file = exported(project);
    const std::size_t nodes = project.network->restPositions.size();
    ASSERT_GT(file.count("Points"), nodes);
    const auto corners = file.numbers<std::int64_t>("Polys", "connectivity");
    const auto places = file.numbers<double>("Points", "Points");
    const auto carriers = file.numbers<std::int64_t>("PointData", "node");
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t vertex = project.mesh->triangles[i / 3][i % 3];
        const auto point = static_cast<std::size_t>(corners[i]);
        EXPECT_EQ(places[3 * point + 1], project.mesh->vertices[vertex].y());
        EXPECT_EQ(carriers[point], project.network->vertexNodes[vertex]);
    }
    const TissueModel tissue = evaluateModel(project);
    const auto constants = file.numbers<double>("PointData", "spring_constant");
    const auto [least, most] =
        std::minmax_element(tissue.springConstant.begin(), tissue.springConstant.end());
    for (const double constant : constants)
        EXPECT_TRUE(constant >= *least * (1 - 1e-12) && constant <= *most * (1 + 1e-12)) << constant;
    EXPECT_DOUBLE_EQ(sum(file.numbers<double>("PointData", "mass")), sum(tissue.mass));
}

TEST_F(VtkFile, GivesVerticesTheMeanOfAllTheirNodes) {
    const Project project = latticeProject();
    const TissueModel tissue = evaluateModel(project);
    const VtpText file = exported(project);
    const auto viscosities = file.numbers<double>("PointData", "viscosity");
    const BindingRows& rows = project.network->binding->vertices;
    const std::size_t nodes = tissue.viscosity.size();
    ASSERT_EQ(viscosities.size(), nodes + rows.size());
    for (std::size_t vertex = 0; vertex < rows.size(); ++vertex) {
        double mean = 0;
        for (std::size_t i = rows.starts[vertex]; i < rows.starts[vertex + 1]; ++i)
            mean += rows.shares[i] * tissue.viscosity[rows.nodes[i]];
        EXPECT_DOUBLE_EQ(viscosities[nodes + vertex], mean);
    }
}

TEST_F(VtkFile, HoldsWhatHasNoCellsAsArraysOfTheWhole) {
    Project project = filledProject();
    const VtpText file = exported(project);
    EXPECT_EQ(file.numbers<std::int32_t>("FieldData", "tetrahedra_nodes").size(),
              4 * project.network->lattice->tetrahedra.size());
    const auto points = file.numbers<std::int32_t>("FieldData", "vertices_point");
    const auto places = file.numbers<double>("Points", "Points");
    ASSERT_EQ(points.size(), project.mesh->vertices.size());
    for (std::size_t vertex = 0; vertex < points.size(); ++vertex)
        EXPECT_EQ(places[3 * static_cast<std::size_t>(points[vertex]) + 2],
                  project.mesh->vertices[vertex].z());
}

TEST_F(VtkFile, HoldsHingesAndStiffening) {
    Project project = biphasicProject();
    project.base.resistsBending = true;
    const TissueModel tissue = evaluateModel(project);
    const VtpText file = exported(project);
    const auto stiffness = file.numbers<double>("FieldData", "hinges_stiffness");
    ASSERT_EQ(stiffness.size(), tissue.hinges.size());
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        EXPECT_EQ(stiffness[i], tissue.hinges[i].stiffness);
    EXPECT_THAT(file.numbers<double>("FieldData", "model_stiffening_strain"),
                testing::ElementsAre(tissue.stiffening->strain));
    EXPECT_TRUE(file.contains("location=\"vtkDataArray\">N·m·s/rad<"));
}

TEST_F(VtkFile, NamesTheRegionOfEveryPoint) {
    const Project project = boundProject({Detail::Kind::Nodes, 20});
    const VtpText file = exported(project);
    const auto regions = file.numbers<std::int32_t>("PointData", "region");
    const auto nodes = file.numbers<std::int64_t>("PointData", "node");
    ASSERT_EQ(regions.size(), file.count("Points"));
    for (std::size_t point = 0; point < regions.size(); ++point) {
        const Eigen::Vector3d& place = project.network->restPositions[static_cast<std::size_t>(nodes[point])];
        EXPECT_EQ(weightAt(project.regions[static_cast<std::size_t>(regions[point])], place), 1);
    }
}

TEST_F(VtkFile, AGridHoldsTetrahedraAsCells) {
    const Project project = filledProject();
    const VtpText file = exported(project, m_folder / "organ.vtu");
    const auto corners = file.numbers<std::int64_t>("Cells", "connectivity");
    const auto ends = file.numbers<std::int64_t>("Cells", "offsets");
    const auto types = file.numbers<std::uint8_t>("Cells", "types");
    const auto counts = file.numbers<std::uint8_t>("CellData", "corners");
    const auto constants = file.numbers<double>("CellData", "spring_constant");
    const auto ofPoints = file.numbers<double>("PointData", "spring_constant");
    ASSERT_EQ(types.size(), project.network->springs.size() + project.mesh->triangles.size() +
                                project.network->lattice->tetrahedra.size());
    ASSERT_EQ(file.count("Cells"), types.size());
    ASSERT_EQ(constants.size(), types.size());
    std::size_t begin = 0, tetrahedra = 0;
    for (std::size_t cell = 0; cell < types.size(); ++cell) {
        const auto end = static_cast<std::size_t>(ends[cell]);
        ASSERT_EQ(end - begin, counts[cell]);
        EXPECT_EQ(types[cell], counts[cell] == 2 ? 3 : counts[cell] == 3 ? 5 : 10);
        double mean = 0;
        for (std::size_t corner = begin; corner < end && types[cell] == 10; ++corner) {
            const auto node = static_cast<std::size_t>(corners[corner]);
            EXPECT_EQ(node, project.network->lattice->tetrahedra[tetrahedra][corner - begin]);
            mean += ofPoints[node] / 4;
        }
        if (types[cell] == 10) {
            EXPECT_DOUBLE_EQ(constants[cell], mean);
            ++tetrahedra;
        }
        begin = end;
    }
    EXPECT_EQ(tetrahedra, project.network->lattice->tetrahedra.size());
}

TEST_F(VtkFile, HoldsAModelWithoutSurface) {
    const VtpText file = exported(bareProject());
    EXPECT_EQ(file.count("Polys"), 0U);
    EXPECT_EQ(file.count("Lines"), bareProject().network->springs.size());
    EXPECT_EQ(file.count("Points"), bareProject().network->restPositions.size());
}

TEST_F(VtkFile, AnExportThatIsCancelledLeavesTheOldFile) {
    exported(bareProject());
    const Bytes before = readFile(m_file);
    EXPECT_THROW(
        exportProject(richProject(), exporterFor(m_file), m_file, {[](double) { return false; }, {}}),
        Cancelled);
    EXPECT_EQ(readFile(m_file), before);
}

} // namespace
} // namespace esm
