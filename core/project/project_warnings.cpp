#include "core/project/project_warnings.h"

#include "core/support/numbers.h"
#include "core/support/offenders.h"

#include <algorithm>

namespace esm {

namespace {

using Warnings = std::vector<std::string>;

/// More than rounding can make of a texture that is full.
constexpr double mostUtilisation = 1 + 1e-6;

Warnings farPoints(const TriangleMesh& mesh) {
    Warnings warnings;
    reportOffenders(warnings, "mesh point", "with a coordinate beyond " + roundedText(largestNumber) + " m",
                    placesWhere(mesh.vertices.size(), [&](std::size_t i) {
                        return !(mesh.vertices[i].array().abs() <= largestNumber).all();
                    }));
    return warnings;
}

std::vector<double> lengthsAtRest(const SpringNetwork& network) {
    std::vector<double> lengths;
    lengths.reserve(network.springs.size());
    for (const Spring& spring : network.springs)
        lengths.push_back(
            (network.restPositions[spring.second] - network.restPositions[spring.first]).stableNorm());
    return lengths;
}

/// A spring that happens to be very short is no slip where its rest length is that of the others.
Warnings pressedSprings(const SpringNetwork& network) {
    const std::vector<double> lengths = lengthsAtRest(network);
    double mean = 0;
    for (const double length : lengths)
        mean += length / static_cast<double>(lengths.size());
    Warnings warnings;
    reportOffenders(warnings, "spring",
                    "with a rest length over " + roundedText(mostPressed) + " times its length at rest",
                    placesWhere(lengths.size(), [&](std::size_t i) {
                        return network.springs[i].restLength > mostPressed * std::max(lengths[i], mean);
                    }));
    return warnings;
}

Warnings withoutSize(const Atlas& atlas) {
    Warnings warnings;
    if (!isPositive(atlas.texelsPerMetre))
        warnings.emplace_back("the texels per metre should be above 0; pack the texture again");
    if (!(atlas.utilisation >= 0 && atlas.utilisation <= mostUtilisation))
        warnings.emplace_back("the part that is used should be from 0 to 1; pack the texture again");
    return warnings;
}

} // namespace

std::vector<std::string> projectWarnings(const Project& project) {
    Warnings warnings;
    addUnder(warnings, "mesh", farPoints(*project.mesh));
    addUnder(warnings, "model", pressedSprings(*project.network));
    if (project.atlas) addUnder(warnings, "texture", withoutSize(*project.atlas));
    return warnings;
}

} // namespace esm
