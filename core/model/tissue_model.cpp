#include "core/model/tissue_model.h"

#include "core/support/numbers.h"
#include "core/support/offenders.h"

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

void checkStiffening(Problems& problems, const TissueModel& model) {
    if (!model.stiffening) return;
    if (const Problems found = fieldProblems(*model.stiffening); !found.empty()) {
        problems.insert(problems.end(), found.begin(), found.end());
        return;
    }
    // Sound factors of sound numbers may still be too large together.
    reportOffenders(problems, "node", "with a spring constant of stretched springs" + withinBounds("0"),
                    placesWhere(model.springConstant.size(), [&](std::size_t i) {
                        const double own = model.springConstant[i];
                        return isAmount(own) && !isAmount(model.stiffening->factor * own);
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

} // namespace

double springConstant(const TissueModel& model, const Spring& spring) {
    return meanOfEnds(model.springConstant, spring);
}

double viscosity(const TissueModel& model, const Spring& spring) {
    return meanOfEnds(model.viscosity, spring);
}

std::vector<std::string> validate(const TissueModel& model) {
    Problems problems;
    if (!model.network) return {"the model has no network of nodes and springs"};
    checkNetwork(problems, *model.network);
    checkNodeParameters(problems, model);
    checkStiffening(problems, model);
    checkTethersAndFixedNodes(problems, model);
    return problems;
}

} // namespace esm
