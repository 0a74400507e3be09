#include "core/model/tissue_model.h"

#include "core/model/scene_cavities.h"
#include "core/support/numbers.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

/// Rest positions and parameters are no larger, so that nothing computed from them overflows: squares of
/// 10³⁰, sums of them over all nodes and quotients by the smallest mass stay far below 10³⁰⁸, where doubles
/// end.
std::string withinBounds(const char* least) {
    return std::string(" that is not ") + least + " to " + roundedText(largestNumber);
}

// Parameters belong to nodes, as regions take in nodes. A spring across a region's border then lies half-way
// between both tissues, and no spring needs a region of its own.
double meanOfEnds(const std::vector<double>& perNode, const Spring& spring) {
    return 0.5 * (perNode[spring.first] + perNode[spring.second]);
}

void checkSize(Problems& problems, const char* list, std::size_t size, std::size_t nodes) {
    if (size != nodes)
        problems.push_back("the list of " + std::string(list) + " has " + std::to_string(size) +
                           " entries for " + std::to_string(nodes) + " nodes");
}

void checkNetwork(Problems& problems, const SpringNetwork& network) {
    const auto& nodes = network.restPositions;
    const auto& springs = network.springs;
    if (nodes.empty()) problems.emplace_back("the model has no nodes");
    reportOffenders(problems, "node",
                    "with a coordinate that is no number or beyond " + roundedText(largestNumber),
                    placesWhere(nodes.size(), [&](std::size_t i) {
                        return !(nodes[i].array().abs() <= largestNumber).all();
                    }));
    reportOffenders(problems, "spring", "joined to a node that does not exist",
                    placesWhere(springs.size(), [&](std::size_t i) {
                        return springs[i].first >= nodes.size() || springs[i].second >= nodes.size();
                    }));
    reportOffenders(
        problems, "spring", "from a node to itself",
        placesWhere(springs.size(), [&](std::size_t i) { return springs[i].first == springs[i].second; }));
    reportOffenders(
        problems, "spring", "with a rest length" + withinBounds("0"),
        placesWhere(springs.size(), [&](std::size_t i) { return !isAmount(springs[i].restLength); }));
    reportOffenders(problems, "mesh point", "carried by a node that does not exist",
                    placesWhere(network.vertexNodes.size(),
                                [&](std::size_t i) { return network.vertexNodes[i] >= nodes.size(); }));
}

void checkNodeParameters(Problems& problems, const TissueModel& model) {
    const std::size_t nodes = model.network->restPositions.size();
    checkSize(problems, "masses", model.mass.size(), nodes);
    checkSize(problems, "spring constants", model.springConstant.size(), nodes);
    checkSize(problems, "viscosities", model.viscosity.size(), nodes);
    const std::string massBounds = withinBounds(roundedText(1 / largestNumber).c_str());
    reportOffenders(problems, "node", "with a mass" + massBounds,
                    placesWhere(model.mass.size(), [&](std::size_t i) { return !isMass(model.mass[i]); }));
    reportOffenders(problems, "node", "with a spring constant" + withinBounds("0"),
                    placesWhere(model.springConstant.size(),
                                [&](std::size_t i) { return !isAmount(model.springConstant[i]); }));
    reportOffenders(
        problems, "node", "with a viscosity" + withinBounds("0"),
        placesWhere(model.viscosity.size(), [&](std::size_t i) { return !isAmount(model.viscosity[i]); }));
}

/// Either every spring has values of its own or none has: a value's place in the list says which spring it is
/// of.
void checkOwnValues(Problems& problems, const TissueModel& model) {
    const auto& values = model.ownValues;
    const std::size_t springs = model.network->springs.size();
    if (!values.empty() && values.size() != springs)
        problems.push_back(std::to_string(values.size()) + " springs have values of their own, of " +
                           std::to_string(springs));
    reportOffenders(problems, "spring", "with a spring constant or viscosity" + withinBounds("0"),
                    placesWhere(values.size(), [&](std::size_t i) {
                        return !isAmount(values[i].springConstant) || !isAmount(values[i].viscosity);
                    }));
}

void checkStiffening(Problems& problems, const TissueModel& model) {
    if (!model.stiffening) return;
    if (const Problems found = fieldProblems(*model.stiffening); !found.empty()) {
        problems.insert(problems.end(), found.begin(), found.end());
        return;
    }
    // Sound factors of sound numbers may still be too large together.
    const auto isTooStiff = [&](double own) {
        return isAmount(own) && !isAmount(model.stiffening->factor * own);
    };
    const std::string fault = "with a spring constant of stretched springs" + withinBounds("0");
    reportOffenders(problems, "node", fault, placesWhere(model.springConstant.size(), [&](std::size_t i) {
                        return isTooStiff(model.springConstant[i]);
                    }));
    reportOffenders(problems, "spring", fault, placesWhere(model.ownValues.size(), [&](std::size_t i) {
                        return isTooStiff(model.ownValues[i].springConstant);
                    }));
}

void checkTethersAndFixedNodes(Problems& problems, const TissueModel& model) {
    const std::size_t nodes = model.network->restPositions.size();
    const auto& tethers = model.tethers;
    const auto& fixed = model.fixedNodes;
    reportOffenders(problems, "tether", "on a node that does not exist",
                    placesWhere(tethers.size(), [&](std::size_t i) { return tethers[i].node >= nodes; }));
    reportOffenders(problems, "tether", "with a spring constant or viscosity" + withinBounds("0"),
                    placesWhere(tethers.size(), [&](std::size_t i) {
                        return !isAmount(tethers[i].springConstant) || !isAmount(tethers[i].viscosity);
                    }));
    reportOffenders(problems, "fixed node", "that does not exist",
                    placesWhere(fixed.size(), [&](std::size_t i) { return fixed[i] >= nodes; }));
    reportOffenders(
        problems, "fixed node", "out of order or named twice",
        placesWhere(fixed.size(), [&](std::size_t i) { return i > 0 && fixed[i] <= fixed[i - 1]; }));
}

void checkCavities(Problems& problems, const TissueModel& model) {
    for (std::size_t i = 0; i < model.cavities.size(); ++i) {
        const Cavity& cavity = model.cavities[i];
        for (std::string& problem : validate(cavity, model.network->restPositions))
            problems.push_back(std::move(problem));
        const auto isSame = [&](const Cavity& other) { return other.part == cavity.part; };
        if (std::any_of(model.cavities.begin(), model.cavities.begin() + static_cast<std::ptrdiff_t>(i),
                        isSame))
            problems.push_back("part " + std::to_string(cavity.part) + " of the surface is filled twice");
    }
    const std::string noRoom = whyNoRoom(*model.network);
    if (!model.cavities.empty() && !noRoom.empty()) problems.push_back(noRoom + "; " + adviceOnRoom);
}

} // namespace

// All that steps or writes springs asks this one function, so that nobody can forget that a cut left values
// of their own.
SpringValues valuesOf(const TissueModel& model, std::size_t spring) {
    if (!model.ownValues.empty()) return model.ownValues[spring];
    const Spring& between = model.network->springs[spring];
    return {meanOfEnds(model.springConstant, between), meanOfEnds(model.viscosity, between)};
}

std::vector<SpringValues> springValues(const TissueModel& model) {
    std::vector<SpringValues> values;
    values.reserve(model.network->springs.size());
    for (std::size_t spring = 0; spring < model.network->springs.size(); ++spring)
        values.push_back(valuesOf(model, spring));
    return values;
}

// Packages hold numbers of 32 bits, whose rounding is a relative 6·10⁻⁸; a mean of two rounded ones is off by
// as much again. Below the smallest normal number singles have fewer digits, and the difference itself is
// compared.
bool isMean(double value, double first, double second) {
    const double allowed = meanTolerance * std::max(std::abs(first), std::abs(second));
    return std::abs(value - (first + second) / 2) <=
           allowed + static_cast<double>(std::numeric_limits<float>::min());
}

// Values that are the mean after all do not count: digests and files of such tissue stay as they were.
bool hasOwnValues(const TissueModel& model) {
    for (std::size_t i = 0; i < model.ownValues.size(); ++i) {
        const auto& [first, second, restLength] = model.network->springs[i];
        const auto& [springConstant, viscosity] = model.ownValues[i];
        if (!isMean(springConstant, model.springConstant[first], model.springConstant[second]) ||
            !isMean(viscosity, model.viscosity[first], model.viscosity[second]))
            return true;
    }
    return false;
}

std::vector<std::string> validate(const TissueModel& model) {
    Problems problems;
    if (!model.network) return {"the model has no network of nodes and springs"};
    checkNetwork(problems, *model.network);
    checkNodeParameters(problems, model);
    checkOwnValues(problems, model);
    checkStiffening(problems, model);
    checkTethersAndFixedNodes(problems, model);
    const Problems ofHinges = hingeProblems(model.hinges, model.network->restPositions);
    problems.insert(problems.end(), ofHinges.begin(), ofHinges.end());
    checkCavities(problems, model);
    return problems;
}

} // namespace esm
