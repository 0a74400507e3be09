#include "app/editor/workers/inside_finder.h"

#include "core/project/simulated_network.h"
#include "core/solid/prism_wall.h"

#include <utility>

namespace esm {

namespace {

constexpr std::chrono::milliseconds rest{120};

/// More would take seconds and much memory each time that a number is typed.
constexpr double mostShownNodes = 1e5;

LatticeFilling withUsual(LatticeFilling asked, const TriangleMesh& mesh) {
    if (isWall(asked)) {
        if (asked.layers == 0) asked.layers = usualLayers(mesh, asked.wallThickness);
    } else if (asked.spacing == 0) {
        return fillingOf(mesh, asked.kind);
    }
    return asked;
}

/// Tells of every twentieth of the work.
Progress toldBy(const InsideFinder::Worker::Task& task, const FoundInside& estimated) {
    return [&task, &estimated, goesOn = task.progress(), told = std::make_shared<double>(0)](double share) {
        if (share >= *told + 0.05) {
            *told = share;
            FoundInside shown = estimated;
            shown.share = share;
            task.show(std::make_shared<const FoundInside>(std::move(shown)));
        }
        return goesOn(share);
    };
}

InsideFinder::Answer insideOf(const TriangleMesh& mesh, const InsideFinder::Worker::Task& task) {
    FoundInside found{withUsual(task.question, mesh), {}, nullptr};
    found.estimate = estimateLattice(mesh, found.filling, task.progress());
    task.show(std::make_shared<const FoundInside>(found));
    const double nodes = found.estimate.nodes;
    if (nodes > mostShownNodes && nodes <= mostLatticeNodes)
        return std::make_shared<const FoundInside>(found);
    found.network = std::make_shared<const SpringNetwork>(
        networkOf(mesh, {Detail::Kind::Filled, 0, found.filling}, toldBy(task, found)));
    return std::make_shared<const FoundInside>(std::move(found));
}

} // namespace

InsideFinder::InsideFinder(std::shared_ptr<const TriangleMesh> mesh, QObject* parent)
    : DialogWorker([mesh = std::move(mesh)](const Worker::Task& task) { return insideOf(*mesh, task); }, rest,
                   parent) {}

} // namespace esm
