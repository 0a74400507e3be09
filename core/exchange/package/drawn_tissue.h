#pragma once

#include "core/exchange/package/glb.h"
#include "core/model/tissue_model.h"

namespace esm {

/// Tissue of every vertex of the surface, or of every node where there is none, for programs that know glTF
/// alone. A vertex has the tissue of its node; where several carry it, their mean by their shares.
struct DrawnTissue {
    std::vector<float> mass;           ///< kg, of the nodes that carry it
    std::vector<float> springConstant; ///< N/m
    std::vector<float> viscosity;      ///< N·s/m
    std::vector<float> fixed;          ///< 1 where it never moves, 0 where it may; between them where some do
    bool isSurface = false;            ///< of vertices, and not of nodes
};

/// @param vertices of the surface; 0: of nodes
DrawnTissue drawnTissue(const TissueModel& tissue, std::size_t vertices);

/// Adds it as vertex attributes of a primitive that draws these vertices: `_ESM_MASS` and so on, and
/// `_ESM_VERTEX`, the vertex' number, where a float holds all of them.
void addTissueAttributes(const DrawnTissue& tissue, const std::vector<std::uint32_t>& vertices,
                         GltfArrays& arrays, nlohmann::ordered_json& attributes);

} // namespace esm
