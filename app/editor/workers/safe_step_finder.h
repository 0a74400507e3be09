#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/model/stepping.h"
#include "core/model/tissue_model.h"

#include <functional>
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

    void find(TissueModel model, Integrator integrator);

private:
    struct Question {
        TissueModel model;
        Integrator integrator;
    };

    static std::optional<double> stepOf(const Question& question, const Progress& progress);
    void tell();

    Found m_found;
    std::mutex m_telling; ///< so that no former model's step is told after a new question
    int m_latest = 0;     ///< question
    LatestWorker<Question, std::optional<double>> m_worker;
};

} // namespace esm
