#include "core/model/scene.h"

#include "core/support/numbers.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

/// Adds problems under the place in the scene they belong to. All are gathered, and not the first one thrown:
/// who mends a scene file sees at once what is wrong with it.
class SceneCheck {
public:
    SceneCheck(std::size_t nodeCount, Problems problems)
        : m_nodeCount(nodeCount), m_problems(std::move(problems)) {}

    void require(bool condition, const std::string& place, const std::string& problem) {
        if (!condition) m_problems.push_back(place + ": " + problem);
    }

    void requireNode(std::uint32_t node, const std::string& place) {
        require(node < m_nodeCount, place,
                "there is no node " + std::to_string(node) + "; " + nodesThereAre());
    }

    /// As one problem, however many nodes are missing: the wrong organ under a scene would else fill pages.
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
        requirePath(path, "[time, x, y, z]", place,
                    [](const PathPoint& point) { return point.value.allFinite(); });
    }

    /// Times that are not numbers are told alone, since no order can be asked of them.
    template<class Point, class IsFinite>
    void requirePath(const std::vector<Point>& path, const std::string& row, const std::string& place,
                     const IsFinite& isFinite) {
        require(!path.empty(), place, "the path has no point; give " + row + " at least once");
        const auto notFinite = [&](std::size_t i) {
            return !std::isfinite(path[i].time) || !isFinite(path[i]);
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
    void add(const Problems& found) { m_problems.insert(m_problems.end(), found.begin(), found.end()); }

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
    for (std::size_t i = 0; i < scene.tethers.size(); ++i)
        check.add(sceneEntry("tethers", i), fieldProblems(scene.tethers[i]));
}

void checkForces(SceneCheck& check, const Scene& scene) {
    for (std::size_t i = 0; i < scene.forces.size(); ++i) {
        const NodeForce& force = scene.forces[i];
        const std::string place = sceneEntry("forces", i);
        check.requireNode(force.node, place);
        check.add(place, fieldProblems(force));
        check.require(std::isfinite(force.from) && std::isfinite(force.to) && force.from <= force.to, place,
                      "from and to must be times, from not after to");
    }
}

void checkSplits(SceneCheck& check, const Scene& scene) {
    for (std::size_t i = 0; i < scene.splits.size(); ++i) {
        const std::string place = sceneEntry("split", i);
        check.add(place, fieldProblems(scene.splits[i]));
        check.require(!scene.splits[i].edges.empty(), place, "name at least one edge");
        std::set<std::uint32_t> nodes;
        for (const auto& [first, second] : scene.splits[i].edges)
            nodes.insert({first, second});
        check.requireNodes({nodes.begin(), nodes.end()}, place);
    }
}

/// With as many nodes as splits may make at most: a path of n edges meets n + 1 nodes, and each becomes two
/// once. How many there are in truth is known only once the splits are made (scene_stages.cpp).
std::size_t nodesAtMost(const Scene& scene, std::size_t nodeCount) {
    if (nodeCount == std::numeric_limits<std::size_t>::max()) return nodeCount;
    for (const SurfaceSplit& split : scene.splits)
        nodeCount += split.edges.size() + 1;
    return nodeCount;
}

/// A node has one path. Of two, the one that stands last would win in silence.
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
}

/// A part has one filling and one pressure: of two, the one that stands last would win in silence.
void checkFluids(SceneCheck& check, const Scene& scene) {
    const auto requireOnce = [&](std::set<std::uint32_t>& parts, std::uint32_t part,
                                 const std::string& place) {
        check.require(parts.insert(part).second, place,
                      "part " + std::to_string(part) + " stands in an earlier entry too; join the two");
    };
    std::set<std::uint32_t> filled, pressed, all;
    for (const auto& filling : scene.fillings)
        all.insert(filling.part);
    for (const auto& pressure : scene.pressures)
        all.insert(pressure.part);
    check.require(all.size() <= mostFluids, "fillings, pressures",
                  "no more than " + std::to_string(mostFluids) + " parts can be filled");
    for (std::size_t i = 0; i < scene.fillings.size(); ++i) {
        check.add(sceneEntry("fillings", i), fieldProblems(scene.fillings[i]));
        requireOnce(filled, scene.fillings[i].part, sceneEntry("fillings", i));
    }
    for (std::size_t i = 0; i < scene.pressures.size(); ++i) {
        const std::string place = sceneEntry("pressures", i);
        const auto& path = scene.pressures[i].path;
        requireOnce(pressed, scene.pressures[i].part, place);
        check.requirePath(path, "[time, pressure]", place,
                          [](const PressurePoint& point) { return std::isfinite(point.pressure); });
        const auto isBeyond = [&](std::size_t point) {
            const double pressure = std::abs(path[point].pressure);
            return std::isfinite(pressure) && pressure > largestNumber;
        };
        Problems found;
        reportOffenders(found, "point", "with a pressure beyond " + roundedText(largestNumber) + " Pa",
                        placesWhere(path.size(), isBeyond));
        check.add(place, found);
    }
}

/// Names stand in CSV files as they are.
bool isPlainName(const std::string& name) {
    return name.size() <= longestInstrumentName && name.find_first_not_of(' ') != std::string::npos &&
           std::none_of(name.begin(), name.end(), [](char letter) {
               const auto byte = static_cast<unsigned char>(letter);
               return letter == ',' || letter == '"' || byte < 0x20 || byte == 0x7f;
           });
}

/// Of a unit quaternion whose four numbers were rounded to six decimals, each is off by 5·10⁻⁷ and the length
/// by 10⁻⁶ at most.
void checkOrientations(SceneCheck& check, const InstrumentMotion& instrument, const std::string& place) {
    const auto& turns = instrument.orientations;
    check.require(turns.empty() || turns.size() == instrument.path.size(), place,
                  "give an orientation with every point of the path, or with none");
    const auto isNone = [&](std::size_t i) {
        constexpr double rounding = 1e-6;
        return !(std::abs(turns[i].norm() - 1) < rounding);
    };
    Problems found;
    reportOffenders(found, "orientation", "not of length 1", placesWhere(turns.size(), isNone));
    check.add(place, found);
}

void checkInstruments(SceneCheck& check, const Scene& scene) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < scene.instruments.size(); ++i) {
        const InstrumentMotion& instrument = scene.instruments[i];
        const std::string place = hasPlainInstrument(scene) ? "instrument" : sceneEntry("instruments", i);
        std::visit([&](const auto& shape) { check.add(place, fieldProblems(shape)); }, instrument.shape);
        check.requirePath(instrument.path, place);
        checkOrientations(check, instrument, place);
        const std::string name = nameOf(scene, i);
        check.require(isPlainName(name), place,
                      "a name needs 1 to " + std::to_string(longestInstrumentName) +
                          " bytes that are not all blanks, without commas, quotes and control "
                          "characters");
        check.require(names.insert(name).second, place,
                      "an earlier instrument is named \"" + name + "\" too; give each a name of its own");
    }
}

} // namespace

std::string sceneEntry(const char* list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

double pressureAt(const PartPressure& pressure, double time) {
    const auto& path = pressure.path;
    const auto later = std::upper_bound(path.begin(), path.end(), time,
                                        [](double t, const PressurePoint& point) { return t < point.time; });
    if (later == path.begin()) return path.front().pressure;
    const PressurePoint& before = *(later - 1);
    if (later == path.end()) return before.pressure;
    const double part = (time - before.time) / (later->time - before.time);
    return before.pressure + part * (later->pressure - before.pressure);
}

// The point after the time is found by halving: each step asks, and a path that was recorded may have many
// points. Straight between two points, which is what a path says; a spline would overshoot where a hand
// stops.
Eigen::Vector3d positionAt(const Path& path, double time) {
    const auto later = std::upper_bound(path.begin(), path.end(), time,
                                        [](double t, const PathPoint& point) { return t < point.time; });
    if (later == path.begin()) return path.front().value;
    const PathPoint& before = *(later - 1);
    if (later == path.end()) return before.value;
    const double part = (time - before.time) / (later->time - before.time);
    return before.value + part * (later->value - before.value);
}

// The orientation turns at an even speed about one axis between two points (spherical interpolation, Shoemake
// 1985). Mixing the four numbers evenly would turn faster in the middle.
ColliderPose poseAt(const InstrumentMotion& instrument, double time) {
    const auto& [shape, path, orientations, name] = instrument;
    ColliderPose pose{positionAt(path, time)};
    if (orientations.empty()) return pose;
    const auto later = std::upper_bound(path.begin(), path.end(), time,
                                        [](double t, const PathPoint& point) { return t < point.time; });
    const auto next = static_cast<std::size_t>(later - path.begin());
    if (next == 0 || next == path.size()) {
        pose.orientation = next == 0 ? orientations.front() : orientations.back();
    } else {
        const double before = path[next - 1].time;
        const double part = (time - before) / (path[next].time - before);
        pose.orientation = orientations[next - 1].slerp(part, orientations[next]).normalized();
    }
    return pose;
}

PlacedCollider placedAt(const InstrumentMotion& instrument, double time) {
    return {instrument.shape, poseAt(instrument, time)};
}

std::string nameOf(const Scene& scene, std::size_t instrument) {
    const std::string& name = scene.instruments[instrument].name;
    return name.empty() ? "instrument " + std::to_string(instrument) : name;
}

bool hasPlainInstrument(const Scene& scene) {
    if (scene.instruments.size() != 1) return scene.instruments.empty();
    const InstrumentMotion& only = scene.instruments.front();
    return std::holds_alternative<Sphere>(only.shape) && only.orientations.empty() && only.name.empty();
}

// What holds from the start on is held against the nodes that there are then, loads and what is recorded also
// against those that splits make.
std::vector<std::string> validate(const Scene& scene, std::size_t nodeCount) {
    SceneCheck ofStart(nodeCount, fieldProblems(scene));
    checkBoundary(ofStart, scene);
    SceneCheck check(nodesAtMost(scene, nodeCount), ofStart.takeProblems());
    checkSplits(check, scene);
    checkForces(check, scene);
    checkMotion(check, scene);
    checkFluids(check, scene);
    checkInstruments(check, scene);
    check.add(fieldProblems(scene.record));
    if (scene.record.nodes) check.requireNodes(*scene.record.nodes, "record.nodes");
    return check.takeProblems();
}

} // namespace esm
