#include "core/project/continuum.h"

#include "core/project/shared_tissue.h"
#include "core/project/wall.h"
#include "core/solid/lattice_elasticity.h"

#include <cmath>

namespace esm {

namespace {

constexpr double ratioOfNets = 1.0 / 3; ///< Poisson's, of the regular triangular net of springs

double simulatedArea(const Project& project) {
    const SpringNetwork& network = *project.network;
    return surfaceArea({network.restPositions, simulatedSurface(*project.mesh, network)});
}

double filledVolume(const SpringNetwork& network) {
    double volume = 0;
    for (const Tetrahedron& corners : network.lattice->tetrahedra)
        volume += volumeOf(corners, network.restPositions);
    return volume;
}

} // namespace

std::optional<EquivalentMaterial> continuumOf(const Project& project, const TissueModel& tissue) {
    const SpringNetwork& network = *project.network;
    const auto& lattice = network.lattice;
    if (!network.sheet && (!lattice || lattice->filling.kind == LatticeKind::BareDiamond))
        return std::nullopt;
    const bool isWallOfPrisms = lattice && isWall(lattice->filling);
    EquivalentMaterial material;
    if (!lattice) material.thickness = project.base.wallThickness;
    if (isWallOfPrisms) material.thickness = lattice->filling.wallThickness;
    material.poissonsRatio =
        lattice && !isWallOfPrisms ? elasticityOf(lattice->filling.kind).poissonsRatio() : ratioOfNets;
    const double volume =
        lattice ? filledVolume(network) : simulatedArea(project) * project.base.wallThickness;
    const std::vector<double> sizes = nodeSizes(network);
    const double mean = volume / static_cast<double>(sizes.size()); // m³
    constexpr Limits<double> stored{"", 1 / largestNumber, largestNumber};
    for (std::size_t node = 0; node < sizes.size(); ++node) {
        material.youngsModulus.push_back(
            youngsModulusOfWall(tissue.springConstant[node], project.base.wallThickness));
        material.density.push_back(tissue.mass[node] / (sizes[node] * mean));
    }
    const bool isStored =
        isAllowed(material.density, stored) && isAllowed(material.youngsModulus, amountLimits(""));
    return isStored ? std::optional(std::move(material)) : std::nullopt;
}

} // namespace esm
