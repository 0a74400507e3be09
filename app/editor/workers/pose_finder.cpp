#include "app/editor/workers/pose_finder.h"

#include "core/support/errors.h"

namespace esm {

namespace {

PoseAnswer answerTo(PoseQuestion question) {
    PoseAnswer answer{std::move(question), {}, {}};
    try {
        answer.fit = fitPose(answer.question.pairs, answer.question.camera);
    } catch (const std::exception& error) {
        answer.failure = reasonOf(error);
    }
    return answer;
}

} // namespace

PoseFinder::PoseFinder(QObject* parent)
    : QObject(parent),
      m_worker([](const auto& task) { return std::make_shared<const PoseAnswer>(answerTo(task.question)); },
               [this] { emit answered(); }) {}

} // namespace esm
