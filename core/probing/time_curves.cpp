#include "core/probing/time_curves.h"

#include "core/probing/standing_finger.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int stepsOfRise = 20, stepsOfDuration = 100;
constexpr double growth = 1.2;      ///< of steps, one to the next
constexpr double firstStep = 1e-4;  ///< of the duration
constexpr double firstShare = 0.05; ///< of the radius: the first depth where rest under a force is looked for
constexpr double enoughForce = 3e-4; ///< of the force, that a depth of rest may be off it
constexpr int mostDepths = 60, usualDepths = 20;

/// One number for a curve that need not be exponential: of one that is, this is its time constant. When 1/e
/// of the way from the first value to the last is left for the first time, s after the first.
/// @param values per point
std::optional<double> timeConstantOf(const std::vector<TimedPress>& points, const std::vector<double>& values,
                                     double end) {
    const double way = values.front() - end;
    if (!(std::abs(way) > leastWay * std::abs(end))) return {};
    const double wanted = std::exp(-1.0);
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double before = (values[i - 1] - end) / way, now = (values[i] - end) / way;
        if (now > wanted) continue;
        const double part = (before - wanted) / (before - now);
        return points[i - 1].time + part * (points[i].time - points[i - 1].time) - points.front().time;
    }
    return {};
}

/// Time from `begin` to `end`, s, in steps that grow: what follows a change is fast at first.
std::vector<double> growingTimes(double begin, double end) {
    std::vector<double> times;
    const double span = end - begin;
    double step = firstStep * span, time = begin + step;
    while (time < end) {
        times.push_back(time);
        step = std::min(growth * step, span / stepsOfDuration);
        time += step;
    }
    times.push_back(end);
    return times;
}

void requireWithin(double depth, const TimedTest& test, double force) {
    if (depth > test.thickness)
        throw InvalidModel("a force of " + roundedText(force, 3) +
                           " N presses through the organ there: choose a smaller one");
}

PressPoint restAt(PressedTissue& tissue, double depth) {
    tissue.settle(AtDepth{depth});
    return {depth, tissue.force()};
}

// From depth to depth and then between the last two (regula falsi by the Illinois rule: an end that stays
// twice counts half). A given force would say the same at once, but not on a soft wall: nothing keeps the
// finger from going through it in the middle of the search, where the wall folds.
PressPoint restUnder(double force, const TimedTest& test) {
    PressedTissue tissue = test.fresh();
    PressPoint below{0, 0}, above{0, 0};
    double step = firstShare * tissue.radius();
    for (int i = 0; above.force < force; ++i, step *= growth) {
        if (i == mostDepths)
            throw InvalidModel("the organ does not resist a force of " + roundedText(force, 3) +
                               " N there: choose a smaller one");
        below = above;
        requireWithin(below.depth + step, test, force);
        above = restAt(tissue, below.depth + step);
    }
    double missing = force - below.force, beyond = above.force - force;
    PressPoint last = above;
    for (int i = 0; i < mostDepths && std::abs(last.force - force) > enoughForce * force; ++i) {
        const double part = missing / (missing + beyond);
        const bool wasAbove = last.force >= force;
        last = restAt(tissue, below.depth + part * (above.depth - below.depth));
        const bool isAbove = last.force >= force;
        (isAbove ? above : below) = last;
        (isAbove ? beyond : missing) = std::abs(last.force - force);
        if (i > 0 && isAbove == wasAbove) (isAbove ? missing : beyond) /= 2;
    }
    return last;
}

} // namespace

// Balance after balance, by the implicit Euler rule, with the tissue's own masses and dampers. A simulation
// moves its instruments along given paths and cannot ask how deep a force goes; here a depth is one unknown
// more. The rule's error falls with the steps, which are short where forces change.
TimeCurve relaxationCurve(const TimedTest& test, const RelaxationTest& wanted, const PressPoint& end,
                          const Progress& progress) {
    PressedTissue tissue = test.fresh();
    TimeCurve curve{{{0, 0, 0}}, end, {}, false};
    const double rise = wanted.rise;
    std::vector<double> times;
    for (int i = 1; i < stepsOfRise; ++i)
        times.push_back(rise * i / stepsOfRise);
    times.push_back(rise);
    for (const double time : growingTimes(rise, wanted.duration))
        times.push_back(time);
    for (const double time : times) {
        reportProgress(progress,
                       static_cast<double>(curve.points.size() - 1) / static_cast<double>(times.size()));
        const double depth = time < rise ? end.depth * time / rise : end.depth;
        tissue.step(AtDepth{depth}, time - curve.points.back().time);
        curve.points.push_back({time, depth, tissue.force()});
    }
    curve.meetsFixed = tissue.meetsImmovable();
    const double start = standingFinger(curve).largest.time;
    const auto first = std::find_if(curve.points.begin(), curve.points.end(),
                                    [&](const TimedPress& point) { return point.time >= start; });
    const std::vector<TimedPress> after(first, curve.points.end());
    std::vector<double> forces;
    forces.reserve(after.size());
    for (const TimedPress& point : after)
        forces.push_back(point.force);
    curve.timeConstant = timeConstantOf(after, forces, end.force);
    return curve;
}

TimeCurve creepCurve(const TimedTest& test, const CreepTest& wanted, const Progress& progress) {
    PressedTissue tissue = test.fresh();
    TimeCurve curve{{{0, 0, wanted.force}}, {0, wanted.force}, {}, false};
    std::vector<double> depths{0};
    const std::vector<double> times = growingTimes(0, wanted.duration);
    for (const double time : times) {
        reportProgress(progress, static_cast<double>(depths.size() - 1) /
                                     static_cast<double>(times.size() + usualDepths));
        tissue.step(UnderForce{wanted.force}, time - curve.points.back().time);
        requireWithin(tissue.depth(), test, wanted.force);
        curve.points.push_back({time, tissue.depth(), tissue.force()});
        depths.push_back(tissue.depth());
    }
    curve.end = restUnder(wanted.force, test);
    curve.meetsFixed = tissue.meetsImmovable();
    curve.timeConstant = timeConstantOf(curve.points, depths, curve.end.depth);
    return curve;
}

} // namespace esm
