#pragma once

#include "app/editor/workers/latest_input.h"
#include "core/dynamics/simulation.h"

#include <QThread>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace esm {

/// Works out how far the time step may go, on an idle thread of its own: it never takes time from the motion.
/// A model that comes while it works replaces the one it works on; only the latest one's result is told.
class SafeStepFinder {
public:
    /// s; infinite without a limit, none where no step is stable or while it is being sought.
    using Found = std::function<void(std::optional<double> safeStep)>;

    /// @param found called on the finder's thread, and by find()
    explicit SafeStepFinder(Found found);
    ~SafeStepFinder();

    void find(TissueModel model, Integrator integrator);

private:
    struct Question {
        TissueModel model;
        Integrator integrator;
    };

    void work();

    Found m_found;
    std::mutex m_telling; ///< so that no former model's step is told after a new question
    LatestInput<Question> m_questions;
    std::unique_ptr<QThread> m_thread;
};

} // namespace esm
