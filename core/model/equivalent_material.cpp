#include "core/model/equivalent_material.h"

#include "core/support/fields.h"

#include <string>

namespace esm {

std::vector<std::string> validate(const EquivalentMaterial& material, std::size_t nodes) {
    std::vector<std::string> problems;
    const auto check = [&](const auto& value, const Limits<double>& limits) {
        if (!isAllowed(value, limits))
            problems.push_back(std::string(limits.name) + " must be " + limitsText(limits));
    };
    check(material.poissonsRatio, {"Poisson's ratio", 0, 0.5});
    check(material.thickness, positiveLimits("the thickness", "m", largestNumber));
    check(material.youngsModulus, amountLimits("Young's modulus", "Pa"));
    check(material.density, positiveLimits("the density", "kg/m³"));
    if (material.youngsModulus.size() != nodes || material.density.size() != nodes)
        problems.emplace_back("there must be a modulus and a density for each node");
    return problems;
}

} // namespace esm
