#pragma once

#include "app/editor/workers/poke_motion.h"
#include "app/editor/workers/prepared_project.h"
#include "app/editor/workers/preview_run.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"

namespace esm {

/// The sample liver by few nodes.
inline Project pokedOrgan(std::size_t nodes = 500) {
    return withDetail(makeSample("liver"), {Detail::Kind::Nodes, nodes});
}

/// As a hand does: it takes hold of a node, leads it away within a while and lets go.
inline PreviewLoads handAt(const Project& project, double time) {
    constexpr std::uint32_t node = 40;
    constexpr double taken = 0.1, goesFor = 0.3, letGo = 0.5; // s
    PreviewLoads loads;
    if (time < taken || time >= letGo) return loads;
    const double part = std::min((time - taken) / goesFor, 1.0);
    loads.pull = Pull{node, project.network->restPositions[node] + part * Eigen::Vector3d(0.01, 0.02, 0)};
    return loads;
}

/// A run as the preview makes it, frame by frame, that is recorded.
struct RecordedRun {
    explicit RecordedRun(const Project& project) : recorder(project.network) {
        run.take(prepareProject(project));
        while (run.time() < 0.8) {
            const PreviewLoads loads = handAt(project, run.time());
            recorder.note(run.time(), loads);
            run.advance(1.0 / 60, loads);
            recorder.goOn(run.time());
        }
    }

    PreviewRun run;
    PokeRecorder recorder;
};

} // namespace esm
