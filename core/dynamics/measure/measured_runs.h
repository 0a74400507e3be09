#pragma once

#include "core/model/detail.h"
#include "core/model/stepping.h"

#include <optional>
#include <string>

namespace esm {

/// What one way to step came to on a scene.
struct TradeoffRun {
    Stepping stepping;
    std::size_t nodes = 0; ///< simulated
    bool stable = false;
    double error = 0;          ///< relative to the motion itself; without meaning when not stable
    bool isErrorBound = false; ///< the error is that or less: too small to be told from the reference's own
    double wallPerSimulatedSecond = 0;  ///< on this machine
    std::optional<Detail> coarser = {}; ///< the level of detail, where it is not the scene's own

    double realTimeFactor() const { return 1 / wallPerSimulatedSecond; }
    /// Tissue that never moves is as far off as the motion is large: no run may be.
    bool isOfUse() const { return stable && error < 1; }
    bool operator==(const TradeoffRun&) const = default;
};
template<>
inline constexpr auto fieldsOf<TradeoffRun> =
    fieldTable(fieldsOfMember(&TradeoffRun::stepping), field("nodes", &TradeoffRun::nodes),
               field("stable", &TradeoffRun::stable),
               field("error", &TradeoffRun::error, errorLimits).onlyWhere([](const TradeoffRun& run) {
                   return run.stable;
               }),
               field("isErrorBound", &TradeoffRun::isErrorBound).whenSet(),
               field("wallPerSimulatedSecond", &TradeoffRun::wallPerSimulatedSecond, wallTimeLimits)
                   .onlyWhere([](const TradeoffRun& run) { return run.stable; }),
               field("coarser", &TradeoffRun::coarser).whenSet());

/// A way to step that was not measured, and why.
struct LeftOutRun {
    Stepping stepping;
    std::size_t nodes = 0; ///< simulated
    std::string reason;    ///< "would take 3.2 s, more than the 1 s that it may"

    bool operator==(const LeftOutRun&) const = default;
};
template<>
inline constexpr auto fieldsOf<LeftOutRun> = fieldTable(fieldsOfMember(&LeftOutRun::stepping),
                                                        field("nodes", &LeftOutRun::nodes),
                                                        field("reason", &LeftOutRun::reason));

struct TradeoffReference {
    Stepping stepping;
    double estimatedError = 0; ///< relative to the motion
    /// Its steps damp away swings of the tissue that go on in truth: no error contains anything of them.
    bool hidesSwings = false;

    bool operator==(const TradeoffReference&) const = default;
};
template<>
inline constexpr auto fieldsOf<TradeoffReference> =
    fieldTable(fieldsOfMember(&TradeoffReference::stepping),
               field("estimatedError", &TradeoffReference::estimatedError, errorLimits),
               field("hidesSwings", &TradeoffReference::hidesSwings).whenSet());

struct Tradeoff {
    TradeoffReference reference;
    std::vector<TradeoffRun> runs;
    std::vector<std::size_t> pareto; ///< runs of less error than the motion itself that none beats in error
                                     ///< and cost, the fastest first
    std::optional<std::size_t> bestInRealTime; ///< least error
    std::optional<std::size_t> fastestToError; ///< least cost
    std::vector<LeftOutRun> leftOut;
};

/// Of each run, whether none beats it in error and cost.
std::vector<bool> unbeatenRuns(const Tradeoff& tradeoff);

struct TradeoffWishes {
    double realTimeFactor = 1; ///< at least: simulated over wall time
    double mostError = 0.01;   ///< relative to the motion
};

/// Works out anew what is best of the runs there are, as when other wishes come up.
void recommend(Tradeoff& tradeoff, const TradeoffWishes& wishes);

} // namespace esm
