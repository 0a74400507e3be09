#include "core/exchange/package/drawn_tissue.h"

#include <algorithm>

// Application-specific attributes of glTF are floats here: unsigned int is not allowed for them, and 16 bits
// end at 65 535 vertices.

namespace esm {

namespace {

constexpr std::size_t countedByFloats = std::size_t{1} << 24; ///< whole numbers from 0 on that a float holds

/// A share may be below 0, beyond the nodes of a lattice; no vertex has more or less than its nodes.
float carriedValue(const VertexBinding& vertex, const std::vector<double>& ofNodes, double ofMainNode) {
    double value = 0, least = ofMainNode, most = ofMainNode;
    for (std::size_t i = 0; i < vertex.nodes.size(); ++i) {
        if (vertex.shares[i] == 0) continue;
        const double ofNode = ofNodes[vertex.nodes[i]];
        value += vertex.shares[i] * ofNode;
        least = std::min(least, ofNode);
        most = std::max(most, ofNode);
    }
    return static_cast<float>(std::clamp(value, least, most));
}

std::vector<float> drawnValues(const SpringNetwork& network, const std::vector<double>& ofNodes,
                               std::size_t vertices) {
    if (vertices == 0) return {ofNodes.begin(), ofNodes.end()};
    std::vector<float> values;
    values.reserve(vertices);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const double ofMainNode = ofNodes[network.vertexNodes[vertex]];
        values.push_back(network.binding
                             ? carriedValue(network.binding->vertices[vertex], ofNodes, ofMainNode)
                             : static_cast<float>(ofMainNode));
    }
    return values;
}

} // namespace

DrawnTissue drawnTissue(const TissueModel& tissue, std::size_t vertices) {
    std::vector<double> fixed(tissue.mass.size(), 0);
    for (const std::uint32_t node : tissue.fixedNodes)
        fixed[node] = 1;
    const auto drawn = [&](const std::vector<double>& ofNodes) {
        return drawnValues(*tissue.network, ofNodes, vertices);
    };
    return {drawn(tissue.mass), drawn(tissue.springConstant), drawn(tissue.viscosity), drawn(fixed),
            vertices > 0};
}

void addTissueAttributes(const DrawnTissue& tissue, const std::vector<std::uint32_t>& vertices,
                         GltfArrays& arrays, nlohmann::ordered_json& attributes) {
    const auto add = [&](const char* name, const auto& valueOf) {
        std::vector<float> values(vertices.size());
        std::transform(vertices.begin(), vertices.end(), values.begin(), valueOf);
        attributes[name] = arrays.addFloats(values, GltfType::Scalar, GltfTarget::Vertices);
    };
    const auto addOf = [&](const char* name, const std::vector<float>& ofVertices) {
        add(name, [&](std::uint32_t vertex) { return ofVertices[vertex]; });
    };
    addOf("_ESM_MASS", tissue.mass);
    addOf("_ESM_SPRING_CONSTANT", tissue.springConstant);
    addOf("_ESM_VISCOSITY", tissue.viscosity);
    addOf("_ESM_FIXED", tissue.fixed);
    if (tissue.isSurface && tissue.mass.size() <= countedByFloats)
        add("_ESM_VERTEX", [](std::uint32_t vertex) { return static_cast<float>(vertex); });
}

} // namespace esm
