#include "core/exchange/simulators/vtp_file.h"

#include "core/exchange/tissue_json.h"
#include "core/support/byte_order.h"

#include <algorithm>
#include <array>
#include <numeric>

// The file is XML whose arrays follow each other as raw bytes behind the last element ("appended"), each
// after its length in 64 bits. That is VTK's own default: half the size of text and exact, and any version
// from 5 on reads it.

namespace esm {

namespace {

template<typename Number> constexpr const char* vtkType() {
    if constexpr (std::is_same_v<Number, double>) return "Float64";
    if constexpr (std::is_same_v<Number, std::int64_t>) return "Int64";
    if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

/// The XML and the bytes behind it while they grow.
class VtpText {
public:
    /// @param arrays there will be
    VtpText(const Progress& progress, std::size_t arrays)
        : m_parts(progress), m_array(1 / static_cast<double>(arrays)) {}

    void add(const std::string& line) { m_text += line + '\n'; }

    /// @param unit empty where it has none
    template<typename Number>
    void addArray(const std::string& name, const std::string& unit, const std::vector<Number>& values,
                  int components = 1) {
        add("<DataArray type=\"" + std::string(vtkType<Number>()) + "\" Name=\"" + name +
            "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"appended\" offset=\"" +
            std::to_string(m_bytes.size()) + "\">");
        if (!unit.empty())
            add(R"(<InformationKey name="UNITS_LABEL" location="vtkDataArray">)" + unit +
                "</InformationKey>");
        add("</DataArray>");
        reportProgress(m_parts.next(m_array), 1);
        appendLittleEndian(m_bytes, std::uint64_t{values.size() * sizeof(Number)});
        for (const Number value : values)
            if constexpr (sizeof(Number) == 1)
                m_bytes.push_back(value);
            else
                appendLittleEndian(m_bytes, value);
    }

    Bytes finished() const {
        const std::string begin = m_text + "<AppendedData encoding=\"raw\">\n_",
                          end = "\n</AppendedData>\n</VTKFile>\n";
        Bytes file(begin.begin(), begin.end());
        file.insert(file.end(), m_bytes.begin(), m_bytes.end());
        file.insert(file.end(), end.begin(), end.end());
        return file;
    }

private:
    ProgressParts m_parts;
    double m_array; ///< share of the whole
    std::string m_text;
    Bytes m_bytes;
};

/// A value for each point or cell.
struct Column {
    const char *name, *unit;
    std::vector<double> values;
};

/// Cells of one kind, as VTK lists them.
struct Cells {
    std::vector<std::int64_t> points, ends; ///< one cell after the other; where each ends
    void add(std::initializer_list<std::size_t> corners) {
        for (const std::size_t corner : corners)
            points.push_back(static_cast<std::int64_t>(corner));
        ends.push_back(static_cast<std::int64_t>(points.size()));
    }
};

/// Every node is a point, and so is every drawn vertex that is not at its node.
struct WrittenPoints {
    std::vector<Eigen::Vector3d> places; ///< m
    std::vector<std::int64_t> nodes;     ///< by point, the node that it is or that carries most of it
    std::vector<std::size_t> ofVertices; ///< by vertex, its point
    std::vector<std::uint32_t> apart;    ///< the vertices that are points of their own, in their order
};

WrittenPoints pointsOf(const TriangleMesh& mesh, const SpringNetwork& network) {
    WrittenPoints points{
        network.restPositions, std::vector<std::int64_t>(network.restPositions.size()), {}, {}};
    std::iota(points.nodes.begin(), points.nodes.end(), std::int64_t{0});
    for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const std::uint32_t node = network.vertexNodes[vertex];
        const bool isAtNode = mesh.vertices[vertex] == network.restPositions[node];
        points.ofVertices.push_back(isAtNode ? node : points.places.size());
        if (isAtNode) continue;
        points.places.push_back(mesh.vertices[vertex]);
        points.nodes.push_back(node);
        points.apart.push_back(vertex);
    }
    return points;
}

/// What nodes have; a vertex apart takes it from the nodes that carry it.
std::vector<double> carriedBy(const SpringNetwork& network, const WrittenPoints& points,
                              const std::vector<double>& ofNodes) {
    std::vector<double> values = ofNodes;
    for (const std::uint32_t vertex : points.apart) {
        double value = ofNodes[network.vertexNodes[vertex]];
        if (network.binding) {
            const auto& [nodes, shares] = network.binding->vertices[vertex];
            value = 0;
            for (std::size_t i = 0; i < nodes.size(); ++i)
                value += shares[i] * ofNodes[nodes[i]];
        }
        values.push_back(value);
    }
    return values;
}

/// The organ as VTK lists it.
struct Content {
    WrittenPoints points;
    Cells single, lines, triangles;
    std::vector<Column> ofPoints, ofCells;
    std::vector<std::uint8_t> fixed; ///< by point
};

void addCells(const Handover& handover, Content& content) {
    const SpringNetwork& network = *handover.tissue.network;
    const TriangleMesh& mesh = *handover.project.mesh;
    const std::vector<std::size_t>& points = content.points.ofVertices;
    for (const Spring& spring : network.springs)
        content.lines.add({spring.first, spring.second});
    for (const Triangle& triangle : mesh.triangles)
        content.triangles.add({points[triangle[0]], points[triangle[1]], points[triangle[2]]});
    if (!network.springs.empty() || !mesh.triangles.empty()) return;
    for (std::size_t node = 0; node < network.restPositions.size(); ++node)
        content.single.add({node});
}

/// Masses and tethers are the nodes' alone, so that sums over all points stay right.
void addPointColumns(const TissueModel& tissue, Content& content) {
    std::vector<double> mass = tissue.mass;
    mass.resize(content.points.places.size(), 0);
    std::vector<double> tetherConstant(mass.size(), 0), tetherViscosity = tetherConstant;
    for (const Tether& tether : tissue.tethers) {
        tetherConstant[tether.node] += tether.springConstant;
        tetherViscosity[tether.node] += tether.viscosity;
    }
    content.fixed.resize(mass.size(), 0);
    for (const std::uint32_t node : tissue.fixedNodes)
        content.fixed[node] = 1;
    const auto carried = [&](const std::vector<double>& ofNodes) {
        return carriedBy(*tissue.network, content.points, ofNodes);
    };
    content.ofPoints = {{"mass", "kg", std::move(mass)},
                        {"spring_constant", "N/m", carried(tissue.springConstant)},
                        {"viscosity", "N·s/m", carried(tissue.viscosity)},
                        {"tether_spring_constant", "N/m", std::move(tetherConstant)},
                        {"tether_viscosity", "N·s/m", std::move(tetherViscosity)}};
}

/// What single points and springs have, and triangles on the mean of their corners.
std::vector<double> ofAllCells(const Content& content, const std::vector<double>& ofSprings,
                               const std::vector<double>& ofPoints) {
    std::vector<double> values;
    const auto valueAt = [&](std::int64_t point) { return ofPoints[static_cast<std::size_t>(point)]; };
    std::transform(content.single.points.begin(), content.single.points.end(), std::back_inserter(values),
                   valueAt);
    values.insert(values.end(), ofSprings.begin(), ofSprings.end());
    const std::vector<std::int64_t>& corners = content.triangles.points;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        values.push_back((valueAt(corners[i]) + valueAt(corners[i + 1]) + valueAt(corners[i + 2])) / 3);
    return values;
}

/// Precondition: the columns of the points are there.
void addCellColumns(const TissueModel& tissue, Content& content) {
    std::vector<double> springConstants, viscosities, restLengths;
    for (const auto& [springConstant, viscosity] : springValues(tissue)) {
        springConstants.push_back(springConstant);
        viscosities.push_back(viscosity);
    }
    for (const Spring& spring : tissue.network->springs)
        restLengths.push_back(spring.restLength);
    const std::vector<double> none(content.points.places.size(), 0);
    content.ofCells = {
        {"spring_constant", "N/m", ofAllCells(content, springConstants, content.ofPoints[1].values)},
        {"viscosity", "N·s/m", ofAllCells(content, viscosities, content.ofPoints[2].values)},
        {"rest_length", "m", ofAllCells(content, restLengths, none)}};
}

Content contentOf(const Handover& handover, const Progress& progress) {
    Content content{pointsOf(*handover.project.mesh, *handover.tissue.network), {}, {}, {}, {}, {}, {}};
    reportProgress(progress, 0.25);
    addCells(handover, content);
    reportProgress(progress, 0.5);
    addPointColumns(handover.tissue, content);
    reportProgress(progress, 0.75);
    addCellColumns(handover.tissue, content);
    reportProgress(progress, 1);
    return content;
}

void writeCells(VtpText& text, const std::string& kind, const Cells& cells) {
    text.add("<" + kind + ">");
    text.addArray("connectivity", "", cells.points);
    text.addArray("offsets", "", cells.ends);
    text.add("</" + kind + ">");
}

std::string countsOf(const Content& content) {
    const auto count = [](const char* name, std::size_t number) {
        return std::string(" ") + name + "=\"" + std::to_string(number) + "\"";
    };
    return count("NumberOfPoints", content.points.places.size()) +
           count("NumberOfVerts", content.single.ends.size()) +
           count("NumberOfLines", content.lines.ends.size()) + count("NumberOfStrips", 0) +
           count("NumberOfPolys", content.triangles.ends.size());
}

Bytes vtpOf(const Content& content, const Progress& progress) {
    constexpr std::size_t others = 11; // nodes, what is fixed, places, and two of each kind of cells
    VtpText text(progress, content.ofPoints.size() + content.ofCells.size() + others);
    text.add(R"(<?xml version="1.0" encoding="UTF-8"?>)");
    text.add(R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">)");
    text.add("<PolyData>\n<Piece" + countsOf(content) + ">");
    text.add(R"(<PointData Scalars="spring_constant">)");
    for (const auto& [name, unit, values] : content.ofPoints)
        text.addArray(name, unit, values);
    text.addArray("fixed", "", content.fixed);
    text.addArray("node", "", content.points.nodes);
    text.add("</PointData>\n<CellData Scalars=\"spring_constant\">");
    for (const auto& [name, unit, values] : content.ofCells)
        text.addArray(name, unit, values);
    text.add("</CellData>\n<Points>");
    text.addArray("Points", "m", coordinatesOf(content.points.places), 3);
    text.add("</Points>");
    writeCells(text, "Verts", content.single);
    writeCells(text, "Lines", content.lines);
    writeCells(text, "Strips", {});
    writeCells(text, "Polys", content.triangles);
    text.add("</Piece>\n</PolyData>");
    return text.finished();
}

} // namespace

void writeVtp(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    const Content content = contentOf(handover, parts.next(0.2));
    const Bytes bytes = vtpOf(content, parts.next(0.6));
    reportProgress(parts.next(0.05), 0);
    writeFileAtomically(file, bytes, parts.rest());
}

} // namespace esm
