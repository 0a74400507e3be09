#include "core/project/shared_tissue.h"

#include "core/project/wall.h"
#include "core/solid/lattice_elasticity.h"

#include <cmath>

namespace esm {

namespace {

// The words and sliders speak of a wall, whose springs' constant alone says how firm it is. A lattice's
// constants grow with its spacing instead; its modulus does not.
std::vector<double> springFactors(const SpringNetwork& network, double wallThickness) {
    if (network.sheet) return network.sheet->springs;
    if (!network.lattice) return {};
    std::vector<double> factors = network.lattice->springShares;
    const double whole = latticeConstant(network.lattice->filling, youngsModulusOfWall(1, wallThickness));
    for (double& factor : factors)
        factor *= whole;
    return factors;
}

} // namespace

std::vector<SpringValues> sharedValues(const TissueModel& model, double wallThickness) {
    const SpringNetwork& network = *model.network;
    std::vector<SpringValues> values;
    const std::vector<double> factors = springFactors(network, wallThickness);
    values.reserve(factors.size());
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const auto [first, second, restLength] = network.springs[i];
        values.push_back({factors[i] * (model.springConstant[first] + model.springConstant[second]) / 2,
                          factors[i] * (model.viscosity[first] + model.viscosity[second]) / 2});
    }
    return values;
}

std::vector<double> nodeSizes(const SpringNetwork& network) {
    if (network.sheet) return network.sheet->nodes;
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
