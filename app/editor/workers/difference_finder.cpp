#include "app/editor/workers/difference_finder.h"

#include "app/editor/workers/told_progress.h"

namespace esm {

namespace {

constexpr std::chrono::milliseconds typingPause{120};

DifferenceFinder::Answer differencesFor(const Exporter& exporter, const Handover& handover,
                                        const DifferenceFinder::Worker::Task& task) {
    std::atomic<double> done{0};
    HandoverMeans means;
    means.engine = task.question;
    means.progress = toldProgress(task.progress(), done, [&] {
        task.show(std::make_shared<const FoundDifferences>(FoundDifferences{std::nullopt, done}));
    });
    return std::make_shared<const FoundDifferences>(
        FoundDifferences{differencesOf(handover, exporter, means), 1});
}

} // namespace

DifferenceFinder::DifferenceFinder(const Exporter& exporter, const Handover& handover, QObject* parent)
    : DialogWorker([&exporter,
                    &handover](const Worker::Task& task) { return differencesFor(exporter, handover, task); },
                   typingPause, parent) {}

} // namespace esm
