#include "core/exchange/simulators/vtp_file.h"

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

    /// The numbers of an array within an element such as PointData.
    template<typename Number>
    std::vector<Number> numbers(const std::string& element, const std::string& name) const {
        const std::size_t begin = m_text.find("<" + element), place = m_text.find("Name=\"" + name, begin);
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

class VtpFile : public testing::Test {
protected:
    VtpText exported(const Project& project) const {
        exportProject(project, exporterFor(m_file), m_file);
        return VtpText(m_file);
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.vtp";
};

double sum(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST_F(VtpFile, HoldsSpringsAndTheirTissueToTheLastBit) {
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

TEST_F(VtpFile, HoldsNodesAsPoints) {
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

TEST_F(VtpFile, DrawsTheSurfaceThatFewerNodesCarry) {
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

TEST_F(VtpFile, GivesVerticesTheMeanOfAllTheirNodes) {
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

TEST_F(VtpFile, HoldsAModelWithoutSurface) {
    const VtpText file = exported(bareProject());
    EXPECT_EQ(file.count("Polys"), 0U);
    EXPECT_EQ(file.count("Lines"), bareProject().network->springs.size());
    EXPECT_EQ(file.count("Points"), bareProject().network->restPositions.size());
}

TEST_F(VtpFile, AnExportThatIsCancelledLeavesTheOldFile) {
    exported(bareProject());
    const Bytes before = readFile(m_file);
    EXPECT_THROW(
        exportProject(richProject(), exporterFor(m_file), m_file, {[](double) { return false; }, {}}),
        Cancelled);
    EXPECT_EQ(readFile(m_file), before);
}

} // namespace
} // namespace esm
