#include "app/editor/workers/pose_finder.h"

#include "core/support/errors.h"

namespace esm {

namespace {

PoseAnswer answerTo(PoseQuestion question) {
    PoseAnswer answer{std::move(question), {}, {}};
    try {
        answer.fit = fitPose(answer.question.pairs, answer.question.camera);
    } catch (const std::exception& error) {
        answer.failure = error.what();
    }
    return answer;
}

} // namespace

PoseFinder::PoseFinder(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

PoseFinder::~PoseFinder() {
    m_questions.stop();
    m_thread.join();
}

std::shared_ptr<const PoseAnswer> PoseFinder::answer() const {
    const std::lock_guard lock(m_mutex);
    return m_answer;
}

void PoseFinder::work() {
    while (auto question = m_questions.take()) {
        auto answer = std::make_shared<const PoseAnswer>(answerTo(std::move(*question)));
        {
            const std::lock_guard lock(m_mutex);
            m_answer = std::move(answer);
        }
        emit answered();
    }
}

} // namespace esm
