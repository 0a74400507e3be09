#pragma once

#include "core/dynamics/measure/measured_runs.h"
#include "core/model/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// What speed and accuracy hold for.
struct MeasuredOrgan {
    std::string tissue; ///< tissueDigest
    Scene scene;

    bool operator==(const MeasuredOrgan&) const = default;
};

/// Speed and accuracy of every way to step an organ, as one machine measured them.
struct MeasuredAccuracy {
    MeasuredOrgan organ;
    Detail detail; ///< of the organ
    /// The same organ on the nodes of the run that was chosen last, where these are fewer.
    std::optional<MeasuredOrgan> onFewerNodes;
    TradeoffReference reference;
    std::vector<TradeoffRun> runs;
    std::vector<LeftOutRun> leftOut;

    bool operator==(const MeasuredAccuracy&) const = default;
};

/// Of runs and what was left out: ten times what the largest measurements come to.
constexpr std::size_t mostMeasuredRuns = 5000;

/// Of a run that did not end there is nothing to say.
MeasuredAccuracy measuredAccuracy(MeasuredOrgan organ, const Detail& detail, const Tradeoff& measured);

/// Its runs with what is best of them.
Tradeoff tradeoffOf(const MeasuredAccuracy& accuracy, const TradeoffWishes& wishes);

std::vector<std::string> validate(const MeasuredAccuracy& accuracy);

} // namespace esm
