#pragma once

#include "core/model/surface_split.h"
#include "tests/support/tissue_models.h"

/// Sheets that are cut.
namespace tissue {

using SplitPath = esm::EdgePath;

/// Chain of edges from node to node.
inline SplitPath pathAlong(const std::vector<std::uint32_t>& nodes) {
    SplitPath path;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        path.emplace_back(nodes[i], nodes[i + 1]);
    return path;
}

/// A square of springs and what is drawn of it, node i being vertex i.
struct Sheet {
    esm::Topology topology;
    TissueModel tissue;
};

inline Sheet sheetOf(const esm::TriangleMesh& mesh, const Parameters& parameters = {}) {
    Sheet sheet{{}, fromMesh(mesh, parameters)};
    sheet.topology =
        esm::authoredTopology(std::make_shared<const esm::TriangleMesh>(mesh), sheet.tissue.network);
    return sheet;
}

inline esm::SplitTissue splitSheet(const Sheet& sheet, const SplitPath& path) {
    return esm::splitAlong(sheet.topology, sheet.tissue, path);
}

/// Puts the twins back to the nodes they came from: both sides' motion by their mass.
inline esm::NodeMap joining(const esm::SplitTissue& split) {
    esm::NodeMap map;
    const std::size_t nodes = split.tissue.mass.size() - split.parted.size();
    for (std::uint32_t node = 0; node < nodes; ++node) {
        std::vector<esm::NodeMap::Source> sources{{node, 1}};
        for (const auto& [parted, twin, share] : split.parted)
            if (parted == node) sources = {{node, 1 - share}, {twin, share}};
        map.add(sources);
    }
    return map;
}

} // namespace tissue
