#include "app/editor/workers/part_finder.h"

namespace esm {

PartFinder::PartFinder(QObject* parent)
    : QObject(parent),
      m_worker(
          [](const auto& task) {
              const auto& [mesh, network] = task.question;
              return fillableParts(*mesh, *network, task.progress());
          },
          [this] { QMetaObject::invokeMethod(this, &PartFinder::takeAnswer, Qt::QueuedConnection); }) {}

void PartFinder::find(const Surface& surface) {
    m_isWorking = true;
    m_parts.clear();
    m_worker.ask(surface);
}

void PartFinder::takeAnswer() {
    if (m_worker.isWorking() || !m_isWorking) return;
    m_isWorking = false;
    auto outcome = m_worker.outcome();
    if (outcome.failure.empty()) m_parts = std::move(outcome.answer);
    emit found();
}

} // namespace esm
