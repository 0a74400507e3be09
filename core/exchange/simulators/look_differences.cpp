#include "core/exchange/simulators/look_differences.h"

#include "core/texture/maps/finish_layers.h"

namespace esm {

std::vector<Difference> lookDifferences(const Project& project, const std::string& format) {
    std::vector<Difference> list;
    if (project.mesh->triangles.empty()) return list;
    if (hasFinish(project.layers, project.texture.finish))
        list.push_back({format + " does not say how wet and rough the surface is, nor its relief",
                        "the surface has its colours alone"});
    if (project.texture.occlusionReach > 0)
        list.push_back({format + " has no occlusion", "light reaches all of the surface alike"});
    return list;
}

} // namespace esm
