#include "core/probing/strip.h"

#include "core/dynamics/statics/stretched_tissue.h"
#include "core/probing/probed_spot.h"
#include "core/probing/strip_gauge.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Of what the clamps stretch it by: tissue that is stretched by less is slack, or only straightened.
constexpr double leastStretched = 0.01;

void requireSensible(const StripSettings& settings) {
    std::vector<std::string> problems;
    const auto require = [&](bool isSo, const char* problem) {
        if (!isSo) problems.emplace_back(problem);
    };
    require(isPositive(settings.length), "the strip's length must be above 0 m");
    require(isPositive(settings.width), "the strip's width must be above 0 m");
    require(isPositive(settings.stretch) && settings.stretch <= largestStretch,
            "a strip is stretched by more than 0 and at most to twice its length");
    require(std::isfinite(settings.turn), "the angle that a strip is turned by must be a number");
    require(settings.steps >= 1 && settings.steps <= mostProbeSteps, "it is stretched in 1 to 1000 steps");
    require(!settings.wallThickness || isPositive(*settings.wallThickness),
            "the wall's thickness must be above 0 m");
    if (!problems.empty()) throw InvalidModel(std::move(problems));
}

void requireStretchable(const ProbedOrgan& organ, const StripSettings& settings) {
    if (organ.surface.body)
        throw InvalidModel("the organ moves as one stiff piece, of which no strip can be stretched: choose a "
                           "detail with nodes or fill it");
    if (organ.surface.empty())
        throw InvalidModel("the organ has no surface that a strip could be cut out of");
    const double size = boundingBox(organ.model.network->restPositions).diagonal().norm();
    if (settings.length > size || settings.width > size)
        throw InvalidModel("the organ is " + millimetresText(size, 3) + " large: choose a smaller strip");
}

/// Tissue of no stiffness has no balance to be found, and nothing to be told of.
void requireSprings(const TissueModel& strip) {
    if (std::none_of(strip.ownValues.begin(), strip.ownValues.end(),
                     [](const SpringValues& values) { return values.springConstant > 0; }))
        throw InvalidModel("the springs of the strip have a constant of 0 N/m, and resist nothing: choose "
                           "another place");
}

/// Where tissue would be that gives way evenly between the clamps.
Vectors evenlyStretched(const CutStrip& strip, const Vectors& positions, double rest, double longer) {
    Vectors stretched = positions;
    const Vectors& places = strip.tissue.network->restPositions;
    for (std::size_t i = 0; i < stretched.size(); ++i) {
        const double x = strip.frame.coordinatesOf(places[i]).x() / rest;
        stretched[i] += std::clamp(x, -0.5, 0.5) * longer * strip.frame.along;
    }
    return stretched;
}

// Each stretch begins where the one before came to rest: a strip that was bent is straightened on the way,
// and one that folds keeps to its fold.
/// From the strip at rest on, whose springs may pull where their rest lengths are not those they have.
std::vector<StripPoint> stretchCurve(const CutStrip& strip, const StripSettings& settings,
                                     const StripGauge& gauge, const Progress& progress) {
    const SpringSystem system = makeSpringSystem(strip.tissue);
    double done = 0;
    StretchedTissue tissue(system, [&] { reportProgress(progress, done); });
    std::vector<StripPoint> curve;
    const double whole = settings.stretch * settings.length, stride = whole / settings.steps;
    for (int i = 0; i <= settings.steps; ++i) {
        done = static_cast<double>(i) / (settings.steps + 1);
        tissue.settle(evenlyStretched(strip, tissue.positions(), settings.length, i == 0 ? 0 : stride));
        const double force = tissue.forceOn(strip.clamped[1]).dot(strip.frame.along);
        // The rest that balance leaves over is no force, nor is what it moves tissue by a strain.
        const bool isSlack =
            std::abs(force) <= tissue.leastForce() * static_cast<double>(strip.clamped[1].size());
        curve.push_back({whole * i / settings.steps, isSlack ? 0 : gauge.strain(tissue.positions()),
                         isSlack ? 0 : force});
    }
    return curve;
}

/// N/m, by which a strip pulls more for each metre that the clamps go on.
double stiffnessOf(const StripPoint& from, const StripPoint& to) {
    return (to.force - from.force) / (to.elongation - from.elongation);
}

// The slope of the last step, since a bent strip first is straightened, and a folded one unfolded.
/// Where the strip is taut.
void tellModulus(StripResult& result, double crossSection, const StripSettings& settings, bool isSolid) {
    const StripPoint &from = result.curve[result.curve.size() - 2], &to = result.curve.back();
    const double strain = to.strain - from.strain;
    if (!(strain > leastStretched * (to.elongation - from.elongation) / settings.length) ||
        !(to.force > from.force))
        return;
    const double modulus = (to.force - from.force) / (crossSection * strain);
    if (isSolid)
        result.youngsModulus = modulus;
    else
        result.membraneStiffness = modulus;
    if (!isSolid && settings.wallThickness) result.youngsModulus = modulus / *settings.wallThickness;
}

} // namespace

StripResult pullStrip(const ProbedOrgan& organ, const StripSettings& settings, const Progress& progress) {
    requireSensible(settings);
    requireStretchable(organ, settings);
    const CutStrip strip = cutStrip(organ, settings);
    requireSprings(strip.tissue);
    const StripGauge gauge(strip, settings.length);
    StripResult result;
    result.place = strip.frame.place;
    result.along = strip.frame.along;
    result.nodeCount = strip.tissue.mass.size();
    result.curve = stretchCurve(strip, settings, gauge, progress);
    result.stiffnessAtStart = stiffnessOf(result.curve[0], result.curve[1]);
    result.stiffness = stiffnessOf(result.curve[result.curve.size() - 2], result.curve.back());
    tellModulus(result, gauge.crossSection(), settings, organ.model.network->lattice.has_value());
    reportProgress(progress, 1);
    return result;
}

} // namespace esm
