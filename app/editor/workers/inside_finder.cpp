#include "app/editor/workers/inside_finder.h"

#include "core/project/simulated_network.h"

namespace esm {

namespace {

constexpr std::chrono::milliseconds rest{120};

/// More would take seconds and much memory each time that a number is typed.
constexpr double mostShownNodes = 1e5;

InsideFinder::Answer insideOf(const TriangleMesh& mesh, const InsideFinder::Worker::Task& task) {
    FoundInside found{task.question, {}, nullptr};
    if (found.filling.spacing == 0) found.filling = fillingOf(mesh, found.filling.kind);
    found.estimate = estimateLattice(mesh, found.filling);
    task.show(std::make_shared<const FoundInside>(found));
    const double nodes = found.estimate.nodes;
    if (nodes > mostShownNodes && nodes <= mostLatticeNodes)
        return std::make_shared<const FoundInside>(found);
    found.network = std::make_shared<const SpringNetwork>(
        networkOf(mesh, {Detail::Kind::Filled, 0, found.filling}, task.progress()));
    return std::make_shared<const FoundInside>(std::move(found));
}

} // namespace

InsideFinder::InsideFinder(std::shared_ptr<const TriangleMesh> mesh, QObject* parent)
    : DialogWorker([mesh = std::move(mesh)](const Worker::Task& task) { return insideOf(*mesh, task); }, rest,
                   parent) {}

} // namespace esm
