#include "app/editor/workers/part_finder.h"

namespace esm {

PartFinder::PartFinder(QObject* parent)
    : QObject(parent), m_worker(
                           [](const auto& task) {
                               const auto& [mesh, network] = task.question;
                               return fillableParts(*mesh, *network, task.progress());
                           },
                           [this] { emit found(); }) {}

std::vector<FillablePart> PartFinder::parts() const {
    if (m_worker.isWorking()) return {};
    const auto outcome = m_worker.outcome();
    return outcome.failure.empty() ? outcome.answer : std::vector<FillablePart>();
}

} // namespace esm
