#include "core/probing/probe.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/settling.h"
#include "core/probing/indenter_placing.h"
#include "core/probing/press_curve.h"
#include "core/probing/probed_spot.h"
#include "core/probing/time_curves.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

void requireSensible(const ProbeSettings& settings) {
    std::vector<std::string> problems;
    const auto require = [&](bool isSo, const char* problem) {
        if (!isSo) problems.emplace_back(problem);
    };
    require(isPositive(settings.radius), "the finger's radius must be above 0 m");
    require(isPositive(settings.depth), "the depth to press to must be above 0 m");
    require(settings.steps >= 1 && settings.steps <= mostProbeSteps,
            "the depth is reached in 1 to 1000 steps");
    const auto isTestTime = [](double seconds) { return seconds >= shortestTest && seconds <= longestTest; };
    if (settings.relaxation)
        require(isTestTime(settings.relaxation->rise) && isTestTime(settings.relaxation->duration) &&
                    settings.relaxation->duration >= 1.01 * settings.relaxation->rise,
                "relaxation takes longer than the finger takes to the depth, which is 0.05 s where nothing "
                "else is said, and at most 1000000 s");
    if (settings.creep)
        require(isTestTime(settings.creep->duration) && isPositive(settings.creep->force),
                "creep takes a force above 0 N and a time from 0.000001 s to 1000000 s");
    if (!problems.empty()) throw InvalidModel(std::move(problems));
}

// Said before anything is computed, and of the organ rather than of a matrix that has no factor.
void requirePressable(const ProbedOrgan& organ) {
    if (organ.surface.body)
        throw InvalidModel("the organ moves as one stiff piece, which no finger can dent: choose a detail "
                           "with nodes or fill it");
    if (organ.surface.empty()) throw InvalidModel("the organ has no surface that a finger could touch");
    if (organ.model.fixedNodes.size() >= organ.model.mass.size())
        throw InvalidModel("every node is fixed, so that nothing can be pressed in: fix fewer");
}

/// Beyond these sizes a finger is none, and counting steps by them would never end.
void requireFitting(const ProbedOrgan& organ, const ProbeSettings& settings) {
    const double size = boundingBox(organ.model.network->restPositions).diagonal().norm();
    const double least = size / 10000, most = 10 * size;
    if (settings.radius < least || settings.radius > most)
        throw InvalidModel("the finger's radius must be from " + millimetresText(least, 3) + " to " +
                           millimetresText(most, 3) + ", as the organ is " + millimetresText(size, 3) +
                           " large");
    if (settings.depth > size)
        throw InvalidModel("the organ is " + millimetresText(size, 3) + " large: press less deep than " +
                           millimetresText(settings.depth, 3));
}

// What nothing holds would be pushed away as a whole, and has no place of rest. It stays where it is, as if
// it were fixed; where all of it is so, there is nothing to measure.
SpringSystem heldSystem(const TissueModel& model) {
    SpringSystem system = makeSpringSystem(model);
    const std::vector<Settling> settling = settlingOf(system);
    const auto isLoose = [](const Settling& node) { return !std::isfinite(node.waveTime); };
    if (std::all_of(settling.begin(), settling.end(), isLoose))
        throw InvalidModel("nothing holds the organ, so that a finger would push it away: give it tethers or "
                           "fixed nodes");
    for (std::size_t i = 0; i < settling.size(); ++i)
        if (isLoose(settling[i])) system.fixed[i] = 1;
    return system;
}

// A test has no clock of the scene: what rises or falls later has no place in it. An organ that stands under
// a pressure does so from the beginning on, in the window also while nothing plays.
std::vector<CavityPressure> initialPressures(const TissueModel& model) {
    std::vector<CavityPressure> pressures;
    for (const Cavity& cavity : model.cavities)
        if (const double pressure = cavity.initialPressure; pressure != 0)
            pressures.push_back({cavity.part, pressure, pressure});
    return pressures;
}

std::vector<InflatedPart> inflatedParts(const SpringSystem& system, const InflatedTissue& rest) {
    std::vector<InflatedPart> parts;
    const std::vector<double> volumes = volumesOf(system, rest.positions);
    for (const CavityPressure& pressure : rest.pressures)
        for (std::size_t i = 0; i < volumes.size(); ++i)
            if (const SpringSystem::Filled& cavity = system.cavities[i]; cavity.part == pressure.part)
                parts.push_back({cavity.part, pressure.after, volumes[i], cavity.restVolume});
    return parts;
}

// As deep as the organ, the finger would press one wall through the other, of which neither knows.
void requireWithin(const PlacedIndenter& placed, const ProbeSettings& settings) {
    if (settings.depth >= placed.thickness)
        throw InvalidModel("the organ is " + millimetresText(placed.thickness, 3) + " thick there, so that " +
                           millimetresText(settings.depth, 3) +
                           " would press one side through the other: press less deep");
}

double slopeOf(const PressPoint& from, const PressPoint& to) {
    return (to.force - from.force) / (to.depth - from.depth);
}

// Hertz' contact asks for a solid that is wide and deep beside the finger, and for a flat place. An organ is
// neither, so that this is the modulus of the solid that would feel alike there, not the tissue's own: a
// thin layer on a firm ground feels firmer, a bag on soft tethers softer.
void tellCurve(ProbeResult& result, double radius) {
    const auto& curve = result.curve;
    result.stiffnessAtStart = slopeOf(curve[0], curve[1]);
    result.stiffness = slopeOf(curve[curve.size() - 2], curve.back());
    result.youngsModulus = hertzModulus(curve.back(), result.poissonsRatio, radius);
}

} // namespace

double hertzForce(double youngsModulus, double poissonsRatio, double radius, double depth) {
    return 4.0 / 3 * youngsModulus / (1 - poissonsRatio * poissonsRatio) * std::sqrt(radius) *
           std::pow(depth, 1.5);
}

double hertzModulus(const PressPoint& press, double poissonsRatio, double radius) {
    return press.force / hertzForce(1, poissonsRatio, radius, press.depth);
}

// The organ first swells to where it rests under its pressures, and the finger is set onto it as it stands
// there. Set onto the organ as it is drawn it would begin within tissue that has moved on, or before the
// place that it is to press. Every test begins from that rest anew.
ProbeResult probe(const ProbedOrgan& organ, const ProbeSettings& settings, const Progress& progress) {
    requireSensible(settings);
    requirePressable(organ);
    requireFitting(organ, settings);
    const RayHit place = probedHit(organ, settings.place);
    const SpringSystem system = heldSystem(organ.model);
    double done = 0;
    const Progress watched = [&](double fraction) {
        done = fraction;
        return !progress || progress(fraction);
    };
    ProgressParts parts(watched);
    const std::vector<CavityPressure> pressures = initialPressures(organ.model);
    const double share =
        1.0 / (1 + (pressures.empty() ? 0 : 1) + (settings.relaxation ? 2 : 0) + (settings.creep ? 2 : 0));
    const InflatedTissue rest = inflated(system, pressures, parts.next(pressures.empty() ? 0 : share));
    const PlacedIndenter placed = placedIndenter({organ, rest.positions, system.fixed}, place, settings);
    requireWithin(placed, settings);

    const std::function<PressedTissue()> fresh = [&] {
        return PressedTissue(system, rest, organ.surface.triangles, placed.indenter,
                             [&] { reportProgress(progress, done); });
    };
    PressedTissue tissue = fresh();
    ProbeResult result;
    result.place = spotAt(place, organ.surface.triangles, system.network->restPositions).point;
    result.direction = placed.indenter.inwards;
    result.poissonsRatio = organ.model.network->lattice ? 1.0 / 4 : 1.0 / 3;
    result.inflated = inflatedParts(system, rest);
    result.curve = pressCurve(tissue, settings.depth, settings.steps, parts.next(share));
    result.meetsFixed = tissue.meetsImmovable();
    tellCurve(result, settings.radius);
    const TimedTest timed{fresh, placed.thickness};
    if (settings.relaxation)
        result.relaxation =
            relaxationCurve(timed, *settings.relaxation, result.curve.back(), parts.next(2 * share));
    if (settings.creep) result.creep = creepCurve(timed, *settings.creep, parts.rest());
    for (const auto& curve : {result.relaxation, result.creep})
        result.meetsFixed = result.meetsFixed || (curve && curve->meetsFixed);
    reportProgress(progress, 1);
    return result;
}

} // namespace esm
