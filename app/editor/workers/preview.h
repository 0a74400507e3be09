#pragma once

#include "app/editor/workers/preview_run.h"
#include "app/editor/workers/safe_step_finder.h"

#include <QObject>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace esm {

/// What the window draws.
struct PreviewFrame {
    std::shared_ptr<const SpringNetwork> network; ///< the one the positions belong to
    std::vector<Eigen::Vector3d> positions;       ///< m, one per node
    std::vector<PlacedCollider> instruments;      ///< of the scene that plays
    int project = 0; ///< how many projects had come when the one was that it is computed by
};

/// The running model behind the window, on one thread of its own. What comes in replaces what came before it
/// and was not looked at yet; of what goes out only the latest frame is kept, so a slow window skips frames.
class Preview : public QObject {
    Q_OBJECT

public:
    explicit Preview(QObject* parent = nullptr);
    ~Preview() override;

    void setProject(const Project& project);
    /// How many projects have come: each is evaluated once at most.
    int projectCount() const;
    void setPlaying(bool playing);
    /// Pauses what plays or is about to; plays what does not, from rest when the run had failed.
    void togglePlaying();
    void reset();
    /// Plays the loads of the project's scene from rest, and pauses where it ends.
    void playScene();
    void setPull(const std::optional<Pull>& pull);
    void setInstrument(const std::optional<PlacedCollider>& instrument);
    void setGentleMotion(bool on);
    /// What acts on the tissue from now on.
    PreviewLoads loads() const;

    PreviewFrame frame();
    PreviewStatus status() const;
    /// What the project that came last is made of, evaluated once for all who show it; null while it is
    /// evaluated, and where it cannot be.
    std::shared_ptr<const TissueModel> tissue() const;

signals:
    void frameReady();
    void tissueReady();
    void statusChanged();

private:
    /// Guarded by m_mutex; what the worker has yet to look at.
    struct Inbox {
        std::optional<Project> project;
        int projects = 0; ///< that came so far
        bool isNew = false, reset = false, playScene = false, playing = false, stop = false;
        PreviewLoads loads;
    };

    /// The worker's own.
    struct Worker {
        PreviewRun run;
        int project = 0; ///< the number of the one that the run goes by
        bool playing = false;
        std::chrono::steady_clock::time_point next;
        std::optional<Integrator> gauged; ///< the one whose largest stable step is sought or told
    };

    void work();
    bool workOnce(Worker& worker);
    /// @param number how many projects had come with it
    void takeProject(Worker& worker, const Project& project, int number);
    /// Seeks the largest stable step of the integrator that runs.
    void gauge(Worker& worker);
    /// Ends the run for what went wrong outside the simulation.
    void giveUp(PreviewRun& run, const std::string& reason);
    Inbox collect(bool idle, std::chrono::steady_clock::time_point until);
    void publish(const Worker& worker);
    void takeSafeStep(std::optional<double> step);
    template<typename Change> void send(Change change);

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    Inbox m_inbox;
    PreviewFrame m_frame;
    PreviewStatus m_status;
    std::shared_ptr<const TissueModel> m_tissue;
    int m_tissueProject = 0; ///< the number of the project that it is of
    std::atomic<bool> m_frameAnnounced = false;
    SafeStepFinder m_safeSteps;
    std::thread m_thread;
};

} // namespace esm
