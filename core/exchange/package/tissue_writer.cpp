#include "core/exchange/package/tissue_writer.h"

#include "core/exchange/fields_json.h"
#include "core/exchange/package/package_layout.h"
#include "core/exchange/tissue_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

using Json = nlohmann::ordered_json;

std::vector<float> TissueWriter::floats(const std::vector<double>& values, const char* what) {
    std::vector<float> result;
    result.reserve(values.size());
    for (const double value : values) {
        const bool fits = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
        if (!fits && (m_problems.empty() || m_problems.back().find(what) == std::string::npos))
            m_problems.push_back(std::string(what) + " " + std::to_string(result.size()) +
                                 " is beyond the range of a package's 32-bit numbers");
        result.push_back(fits ? static_cast<float>(value) : 0.0F);
    }
    return result;
}

std::vector<float> TissueWriter::coordinates(const std::vector<Eigen::Vector3d>& points, const char* what) {
    return floats(coordinatesOf(points), what);
}

Json TissueWriter::nodes() {
    m_nodePositions = m_arrays.addFloats(coordinates(m_network.restPositions, "coordinate of a node"),
                                         GltfType::Vec3, GltfTarget::Vertices);
    return {{"count", m_network.restPositions.size()},
            {"restPosition", m_nodePositions},
            {"mass", addScalars(m_tissue.mass, "mass of node")},
            {"springConstant", addScalars(m_tissue.springConstant, "spring constant of node")},
            {"viscosity", addScalars(m_tissue.viscosity, "viscosity of node")}};
}

Json TissueWriter::springs() {
    Json json{{"count", m_network.springs.size()}};
    if (m_network.springs.empty()) return json;
    std::vector<std::uint32_t> ends;
    std::vector<double> restLengths, springConstants, viscosities;
    for (const Spring& spring : m_network.springs) {
        ends.insert(ends.end(), {spring.first, spring.second});
        restLengths.push_back(spring.restLength);
    }
    for (const auto& [springConstant, viscosity] : springValues(m_tissue)) {
        springConstants.push_back(springConstant);
        viscosities.push_back(viscosity);
    }
    m_springNodes = m_arrays.addIndices(ends, GltfTarget::Indices);
    json["nodes"] = m_springNodes;
    json["restLength"] = addScalars(restLengths, "rest length of spring");
    json["springConstant"] = addScalars(springConstants, "spring constant of spring");
    json["viscosity"] = addScalars(viscosities, "viscosity of spring");
    return json;
}

std::size_t TissueWriter::springKinds() {
    std::vector<Edge> outer = uniqueEdges(m_network.lattice->surface);
    std::sort(outer.begin(), outer.end());
    std::vector<std::uint32_t> kinds;
    kinds.reserve(m_network.springs.size());
    for (const Spring& spring : m_network.springs) {
        const Edge edge(std::min(spring.first, spring.second), std::max(spring.first, spring.second));
        kinds.push_back(std::binary_search(outer.begin(), outer.end(), edge)
                            ? package_layout::springOfTheSurface
                            : package_layout::springWithin);
    }
    return m_arrays.addIndices(kinds);
}

Json TissueWriter::material(const EquivalentMaterial& material) {
    Json json{{"poissonsRatio", material.poissonsRatio}};
    if (material.thickness) json["thickness"] = *material.thickness;
    json["youngsModulus"] = addScalars(material.youngsModulus, "Young's modulus at node");
    json["density"] = addScalars(material.density, "density at node");
    return json;
}

Json TissueWriter::tethers() {
    Json json{{"count", m_tissue.tethers.size()}};
    if (m_tissue.tethers.empty()) return json;
    std::vector<std::uint32_t> nodes;
    std::vector<double> springConstants, viscosities;
    for (const Tether& tether : m_tissue.tethers) {
        nodes.push_back(tether.node);
        springConstants.push_back(tether.springConstant);
        viscosities.push_back(tether.viscosity);
    }
    json["nodes"] = m_arrays.addIndices(nodes);
    json["springConstant"] = addScalars(springConstants, "spring constant of tether");
    json["viscosity"] = addScalars(viscosities, "viscosity of tether");
    return json;
}

bool TissueWriter::hasFillings() const {
    return std::any_of(m_tissue.cavities.begin(), m_tissue.cavities.end(),
                       [](const Cavity& cavity) { return cavity.stiffness > 0; });
}

Json TissueWriter::fillings() const {
    Json list = Json::array();
    for (const Cavity& cavity : m_tissue.cavities)
        if (cavity.stiffness > 0) list.push_back(writtenFields(FluidFilling{cavity.part, cavity.stiffness}));
    return list;
}

Json TissueWriter::fixedNodes() {
    Json json{{"count", m_tissue.fixedNodes.size()}};
    if (!m_tissue.fixedNodes.empty()) json["nodes"] = m_arrays.addIndices(m_tissue.fixedNodes);
    return json;
}

Json TissueWriter::hinges() {
    std::vector<std::uint32_t> nodes;
    std::vector<double> stiffnesses, viscosities;
    for (const Hinge& hinge : m_tissue.hinges) {
        nodes.insert(nodes.end(), hinge.nodes.begin(), hinge.nodes.end());
        stiffnesses.push_back(hinge.stiffness);
        viscosities.push_back(hinge.viscosity);
    }
    return {{"count", m_tissue.hinges.size()},
            {"nodes", m_arrays.addIndices(nodes)},
            {"stiffness", addScalars(stiffnesses, "stiffness of hinge")},
            {"viscosity", addScalars(viscosities, "viscosity of hinge")}};
}

Json TissueWriter::binding() {
    const BindingNumbers numbers = numbersOf(*m_network.binding);
    const std::vector<Triangle>& triangles = m_network.binding->surface;
    Json json;
    if (numbers.starts) json["starts"] = m_arrays.addIndices(*numbers.starts);
    json["nodes"] = m_arrays.addIndices(numbers.nodes);
    json["shares"] = m_arrays.addFloats(floats(numbers.shares, "share of a node"),
                                        numbers.starts ? GltfType::Scalar : GltfType::Vec3);
    json["triangleCount"] = triangles.size();
    if (!triangles.empty()) json["triangles"] = m_arrays.addIndices(cornersOf(triangles));
    json["lineCount"] = m_network.binding->lines.size();
    if (!numbers.lines.empty()) json["lines"] = m_arrays.addIndices(numbers.lines);
    return json;
}

Json TissueWriter::sheet() {
    return {{"springShares", addScalars(m_network.sheet->springs, "share of spring")},
            {"nodeShares", addScalars(m_network.sheet->nodes, "share of node")}};
}

Json TissueWriter::lattice() {
    const Lattice& lattice = *m_network.lattice;
    Json json = writtenFields(lattice.filling);
    json["tetrahedronCount"] = lattice.tetrahedra.size();
    json["tetrahedra"] = m_arrays.addIndices(cornersOf(lattice.tetrahedra));
    json["springShares"] = addScalars(lattice.springShares, "share of spring");
    json["triangleCount"] = lattice.surface.size();
    json["triangles"] = m_arrays.addIndices(cornersOf(lattice.surface));
    return json;
}

} // namespace esm
