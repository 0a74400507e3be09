#include "core/model/scene.h"

#include "core/support/numbers.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

/// Adds problems under the place in the scene they belong to.
class SceneCheck {
public:
    explicit SceneCheck(std::size_t nodeCount) : m_nodeCount(nodeCount) {}

    void require(bool condition, const std::string& place, const std::string& problem) {
        if (!condition) m_problems.push_back(place + ": " + problem);
    }

    void requireNode(std::uint32_t node, const std::string& place) {
        require(node < m_nodeCount, place,
                "there is no node " + std::to_string(node) + "; " + nodesThereAre());
    }

    void requireNodes(const std::vector<std::uint32_t>& nodes, const std::string& place) {
        Problems found;
        std::vector<std::size_t> missing;
        std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(missing),
                     [this](std::uint32_t node) { return node >= m_nodeCount; });
        reportOffenders(found, "node", "missing", missing);
        for (std::string& problem : found)
            problem.append("; ").append(nodesThereAre());
        add(place, found);
    }

    void requirePath(const Path& path, const std::string& place) {
        require(!path.empty(), place, "the path has no point; give [time, x, y, z] at least once");
        const auto notFinite = [&](std::size_t i) {
            return !std::isfinite(path[i].time) || !path[i].value.allFinite();
        };
        const auto notRising = [&](std::size_t i) { return i > 0 && !(path[i].time > path[i - 1].time); };
        Problems found;
        reportOffenders(found, "point", "not finite", placesWhere(path.size(), notFinite));
        if (found.empty())
            reportOffenders(found, "point", "not later than the one before it",
                            placesWhere(path.size(), notRising));
        add(place, found);
    }

    void add(const std::string& place, const Problems& found) { addUnder(m_problems, place, found); }

    Problems takeProblems() { return std::move(m_problems); }

private:
    std::string nodesThereAre() const {
        return m_nodeCount == 0 ? "the model has none" : "the last is " + std::to_string(m_nodeCount - 1);
    }

    std::size_t m_nodeCount;
    Problems m_problems;
};

void checkBoundary(SceneCheck& check, const Scene& scene) {
    for (std::size_t i = 0; i < scene.fixed.size(); ++i) {
        const NodeSelection& selection = scene.fixed[i];
        check.requireNodes(selection.nodes, sceneEntry("fixed", i));
        if (selection.ellipsoid)
            check.add(sceneEntry("fixed", i) + ".ellipsoid", validate(*selection.ellipsoid));
    }
    const std::string limit = ", at most " + numberText(largestNumber);
    for (std::size_t i = 0; i < scene.tethers.size(); ++i) {
        const TetherRule& rule = scene.tethers[i];
        const std::string place = sceneEntry("tethers", i);
        check.require(rule.every >= 1, place, "every must be 1 or more");
        check.require(isAmount(rule.springConstant), place, "spring_constant must be 0 N/m or more" + limit);
        check.require(isAmount(rule.viscosity), place, "viscosity must be 0 N·s/m or more" + limit);
    }
}

void checkForces(SceneCheck& check, const Scene& scene) {
    for (std::size_t i = 0; i < scene.forces.size(); ++i) {
        const NodeForce& force = scene.forces[i];
        const std::string place = sceneEntry("forces", i);
        check.requireNode(force.node, place);
        check.require(force.force.allFinite(), place, "the force is not finite");
        check.require(std::isfinite(force.from) && std::isfinite(force.to) && force.from <= force.to, place,
                      "from and to must be times, from not after to");
    }
}

void checkMotion(SceneCheck& check, const Scene& scene) {
    std::set<std::uint32_t> moved;
    for (std::size_t i = 0; i < scene.moves.size(); ++i) {
        const NodeMove& move = scene.moves[i];
        const std::string place = sceneEntry("moves", i);
        check.requireNode(move.node, place);
        check.require(moved.insert(move.node).second, place,
                      "node " + std::to_string(move.node) +
                          " is moved by an earlier entry too; join the two paths");
        check.requirePath(move.path, place);
    }
    if (!scene.instrument) return;
    check.require(isPositive(scene.instrument->radius), "instrument", "the radius must be above 0 m");
    check.requirePath(scene.instrument->path, "instrument");
}

} // namespace

std::string sceneEntry(const char* list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

Eigen::Vector3d positionAt(const Path& path, double time) {
    const auto later = std::upper_bound(path.begin(), path.end(), time,
                                        [](double t, const PathPoint& point) { return t < point.time; });
    if (later == path.begin()) return path.front().value;
    const PathPoint& before = *(later - 1);
    if (later == path.end()) return before.value;
    const double part = (time - before.time) / (later->time - before.time);
    return before.value + part * (later->value - before.value);
}

std::vector<std::string> validate(const Scene& scene, std::size_t nodeCount) {
    SceneCheck check(nodeCount);
    check.require(isPositive(scene.duration), "duration", "must be above 0 s");
    check.require(scene.gravity.allFinite(), "gravity", "is not finite");
    checkBoundary(check, scene);
    checkForces(check, scene);
    checkMotion(check, scene);
    check.require(isPositive(scene.record.every), "record.every", "must be above 0 s");
    if (scene.record.nodes) check.requireNodes(*scene.record.nodes, "record.nodes");
    return check.takeProblems();
}

} // namespace esm
