#include "app/editor/workers/placement_refiner.h"

namespace esm {

PlacementRefiner::PlacementRefiner(QObject* parent)
    : QObject(parent), m_worker(
                           [](const auto& task) {
                               const auto& [mesh, others, photo] = task.question;
                               return refinedPose(*mesh, others, photo, task.progress());
                           },
                           [this] { emit answered(); }) {}

} // namespace esm
