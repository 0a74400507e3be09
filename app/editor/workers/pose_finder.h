#pragma once

#include "app/editor/workers/latest_input.h"
#include "core/texture/projection/pose_fit.h"

#include <QObject>

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace esm {

struct PoseQuestion {
    std::vector<LandmarkPair> pairs;
    PhotoCamera camera;

    bool operator==(const PoseQuestion&) const = default;
};

struct PoseAnswer {
    PoseQuestion question;
    std::optional<PoseFit> fit;
    std::string failure; ///< why there is no fit, in the core's words
};

/// Finds poses from landmarks on a thread of its own: many pairs take longer than a drag may wait. Only the
/// latest question is answered.
class PoseFinder : public QObject {
    Q_OBJECT

public:
    explicit PoseFinder(QObject* parent = nullptr);
    ~PoseFinder() override;

    void find(PoseQuestion question) { m_questions.put(std::move(question)); }
    /// The latest; null before the first.
    std::shared_ptr<const PoseAnswer> answer() const;

signals:
    void answered();

private:
    void work();

    LatestInput<PoseQuestion> m_questions;
    mutable std::mutex m_mutex; ///< guards the answer
    std::shared_ptr<const PoseAnswer> m_answer;
    std::thread m_thread;
};

} // namespace esm
