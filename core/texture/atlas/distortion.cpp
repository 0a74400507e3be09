#include "core/texture/atlas/distortion.h"

#include <algorithm>

namespace esm {

namespace {

/// Layouts may mirror whole patches, which stretches nothing; what counts is a triangle that is folded over
/// within its patch.
std::size_t countFlipped(const std::vector<Stretch>& stretches, const std::vector<std::uint32_t>& patches) {
    std::vector<double> turned(stretches.size(), 0); // of each patch: clockwise area less the rest
    for (std::size_t i = 0; i < stretches.size(); ++i)
        if (stretches[i].larger > 0)
            turned[patches[i]] += stretches[i].isClockwise ? stretches[i].area : -stretches[i].area;
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i)
        if (stretches[i].larger > 0 && stretches[i].isClockwise != (turned[patches[i]] > 0)) ++flipped;
    return flipped;
}

} // namespace

Distortion distortionOf(const TriangleMesh& mesh, const Atlas& atlas) {
    std::vector<Stretch> stretches;
    stretches.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& at = mesh.triangles[i];
        stretches.push_back(
            stretchOf({mesh.vertices[at[0]], mesh.vertices[at[1]], mesh.vertices[at[2]]}, atlas.corners[i]));
    }
    const auto collapsed = std::count_if(stretches.begin(), stretches.end(), [](const Stretch& stretch) {
        return stretch.area > 0 && !(stretch.larger > 0);
    });
    return {angleSpread(stretches), areaSpread(stretches), countFlipped(stretches, patchNumbers(mesh, atlas)),
            static_cast<std::size_t>(collapsed)};
}

} // namespace esm
