#pragma once

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// The continuum that springs stand for, of small strains, as finite elements ask for it.
struct EquivalentMaterial {
    double poissonsRatio = 0;
    std::optional<double> thickness{};   ///< m, of a sheet or wall; none of a body that is filled
    std::vector<double> youngsModulus{}; ///< Pa, per node
    std::vector<double> density{};       ///< kg/m³, per node
};

/// Every problem of one for this many nodes.
std::vector<std::string> validate(const EquivalentMaterial& material, std::size_t nodes);

} // namespace esm
