#include "core/exchange/simulators/mujoco/mujoco_subject.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

/// Of masses, kg, that MuJoCo takes for none (mjMINVAL).
constexpr double leastMujocoMass = 1e-15;
/// Bytes of a tendon's entry of one joint: a number and its place.
constexpr double bytesOfEntry = 12;
/// Bytes that all entries may take. MuJoCo 2.2 counts its memory in 31 bits, with some 0.1 GB for the rest.
constexpr double mostBytes = 1.9e9;

void checkMujocoNodes(const SpringSystem& system) {
    const std::size_t nodes = system.mass.size();
    if (nodes > mostMujocoNodes)
        throw InvalidModel("MuJoCo is given at most " + std::to_string(mostMujocoNodes) +
                           " nodes, since it keeps a row of all joints for every spring, and the organ has " +
                           std::to_string(nodes) + ": import it again with a detail of " +
                           std::to_string(mostMujocoNodes) + ", or hand it over to SOFA");
    for (std::size_t node = 0; node < nodes; ++node)
        if (system.mass[node] < leastMujocoMass)
            throw InvalidModel("node " + std::to_string(node) + " weighs " + roundedText(system.mass[node]) +
                               " kg, and MuJoCo takes less than 1e-15 kg for nothing: raise the mass");
}

std::vector<char> ledNodes(const Handover& handover) {
    std::vector<char> led(handover.tissue.mass.size(), 0);
    for (const NodeMove& move : movesOf(handover))
        led[move.node] = 1;
    return led;
}

std::vector<char> eitherOf(const std::vector<char>& first, const std::vector<char>& second) {
    std::vector<char> either(first.size());
    std::transform(first.begin(), first.end(), second.begin(), either.begin(),
                   [](char one, char other) { return static_cast<char>(one | other); });
    return either;
}

/// What leads a node sees to where it is, whatever the step: it is as one that is fixed.
TissueModel heldTissue(TissueModel tissue, const std::vector<char>& still) {
    tissue.fixedNodes.clear();
    for (std::uint32_t node = 0; node < still.size(); ++node)
        if (still[node]) tissue.fixedNodes.push_back(node);
    return tissue;
}

std::size_t tendonCount(const MujocoSubject& subject) {
    std::size_t count = 3 * subject.rows.size();
    for (const auto& spring : subject.system.springs)
        if (isMovable(subject, spring)) count += spring.secondPhase.isLinear() ? 1 : 2;
    for (const auto& hinge : subject.system.hinges)
        if (isMovable(subject, hinge)) count += 3;
    return count;
}

void checkMujocoMemory(const MujocoSubject& subject) {
    const auto moving = std::count(subject.still.begin(), subject.still.end(), char{0});
    const double bytes =
        static_cast<double>(tendonCount(subject)) * 3 * static_cast<double>(moving) * bytesOfEntry;
    if (bytes > mostBytes)
        throw InvalidModel("MuJoCo would need " + roundedText(bytes / 1e9, 2) + " GB for " +
                           std::to_string(tendonCount(subject)) + " tendons of " + std::to_string(moving) +
                           " nodes, and has room for " + roundedText(mostBytes / 1e9, 2) +
                           " GB: import it again with a detail of fewer nodes, or hand it over to SOFA");
}

void checkMujocoPictures(const Handover& handover, PictureFormat format) {
    if (handover.project.atlas && format != PictureFormat::Png)
        throw InvalidModel("MuJoCo reads PNG alone: hand its pictures over as PNG");
}

} // namespace

MujocoSubject mujocoSubject(const Handover& handover, const SpringSystem& system,
                            const HandoverMeans& means) {
    checkMujocoNodes(system);
    checkMujocoPictures(handover, means.pictures.format);
    MujocoSubject subject{handover, system, means.engine.damping, ledNodes(handover), {}, {}, {}};
    subject.still = eitherOf(subject.led, system.fixed);
    if (subject.damping == Damping::Isotropic) subject.rows = dampingRows(system, subject.still);
    checkMujocoMemory(subject);
    subject.step = mujocoStep(heldTissue(handover.tissue, subject.still), {system, subject.still},
                              means.engine.timeStep, means.progress);
    return subject;
}

double largestStepOf(const MujocoSubject& subject, const Progress& progress) {
    return largestMujocoStep(heldTissue(subject.handover.tissue, subject.still), subject.step.armature,
                             progress);
}

} // namespace esm
