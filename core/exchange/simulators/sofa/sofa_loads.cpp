#include "core/exchange/simulators/sofa/sofa_loads.h"

namespace esm {

namespace {

/// Adding up steps does not come out at a time exactly. What begins then must not wait for another step.
double keyTime(double time, double timeStep) {
    return time > 0 ? time - timeStep / 1000 : time;
}

/// The field goes from key to key, and keeps its last force: nothing.
void addForce(const NodeForce& force, const SofaSubject& subject, XmlText& xml) {
    const double from = keyTime(force.from, subject.timeStep), to = keyTime(force.to, subject.timeStep);
    xml.add("LinearForceField", {{"points", std::to_string(force.node)},
                                 {"times", spaced(std::vector<double>{from, to, to})},
                                 {"forces", spaced(std::vector<Eigen::Vector3d>{force.force, force.force,
                                                                                Eigen::Vector3d::Zero()})}});
}

/// The constraint lets go of its nodes before its first key and beyond its last: the path goes on there. At
/// the end of a step it puts them where the path is at the step's begin, so that all keys are a step earlier.
void addMove(const NodeMove& move, const SofaSubject& subject, XmlText& xml) {
    std::vector<double> times;
    std::vector<Eigen::Vector3d> places;
    const auto addKey = [&](double time, const Eigen::Vector3d& place) {
        times.push_back(time - subject.timeStep);
        places.push_back(place);
    };
    if (move.path.front().time > 0) addKey(0, move.path.front().value);
    for (const PathPoint& point : move.path)
        addKey(point.time, point.value);
    constexpr double forEver = 1e9; // s
    addKey(forEver, places.back());
    const std::string node = std::to_string(move.node);
    xml.add(subject.release.movedConstraint, {{"name", "led-" + node},
                                              {"indices", node},
                                              {"keyTimes", spaced(times)},
                                              {"movements", spaced(places)}});
}

} // namespace

void addSofaLoads(const SofaSubject& subject, XmlText& xml) {
    const std::size_t nodes = subject.system.mass.size();
    for (const NodeForce& force : subject.handover.project.scene.forces)
        if (force.node < nodes && force.to > force.from) addForce(force, subject, xml);
    for (const NodeMove& move : movesOf(subject.handover))
        addMove(move, subject, xml);
}

} // namespace esm
