#include "core/project/solid_tissue.h"

#include "core/project/project.h"
#include "core/solid/lattice_elasticity.h"

#include <cmath>

namespace esm {

double youngsModulusOfWall(double springConstant, double thickness) {
    return 2 * springConstant / (std::sqrt(3.0) * thickness);
}

// The words and sliders speak of a wall, whose springs' constant alone says how firm it is. A lattice's
// constants grow with its spacing instead; its modulus does not.
std::vector<SpringValues> latticeValues(const TissueModel& model) {
    const SpringNetwork& network = *model.network;
    if (!network.lattice) return {};
    const double whole = latticeConstant(network.lattice->filling, youngsModulusOfWall(1, wallThickness));
    std::vector<SpringValues> values;
    values.reserve(network.springs.size());
    for (std::size_t i = 0; i < network.springs.size(); ++i) {
        const auto [first, second, restLength] = network.springs[i];
        const double factor = whole * network.lattice->springShares[i];
        values.push_back({factor * (model.springConstant[first] + model.springConstant[second]) / 2,
                          factor * (model.viscosity[first] + model.viscosity[second]) / 2});
    }
    return values;
}

std::vector<double> nodeSizes(const SpringNetwork& network) {
    const std::size_t nodes = network.restPositions.size();
    if (!network.lattice) return std::vector<double>(nodes, 1);
    std::vector<double> sizes(nodes, 0);
    double volume = 0;
    for (const Tetrahedron& corners : network.lattice->tetrahedra) {
        const double part = volumeOf(corners, network.restPositions);
        volume += part;
        for (const std::uint32_t node : corners)
            sizes[node] += part / 4;
    }
    for (double& size : sizes)
        size *= static_cast<double>(nodes) / volume;
    return sizes;
}

} // namespace esm
