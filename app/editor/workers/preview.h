#pragma once

#include "app/editor/workers/latest_worker.h"
#include "app/editor/workers/poke.h"
#include "app/editor/workers/preview_loads.h"
#include "app/editor/workers/preview_status.h"
#include "app/editor/workers/safe_step_finder.h"
#include "core/project/project.h"

#include <QObject>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace esm {

class MatrixFactoriser;
class PreviewRun;
struct PreparedProject;

/// What the window draws.
struct PreviewFrame {
    std::shared_ptr<const SpringNetwork> network; ///< the one the positions belong to
    std::vector<Eigen::Vector3d> positions;       ///< m, one per node
    std::vector<double> speeds;                   ///< m/s, one per node; empty where nothing can move
    std::vector<PlacedCollider> instruments;      ///< of the scene that plays
    std::optional<PlacedCollider> heldInstrument; ///< where the tissue meets it
    int project = 0; ///< the number of the project that it is computed by, from 1
};

/// The running model behind the window, on a thread of its own. Projects are evaluated and their matrices
/// factorised on a second one, while the model runs on by the parameters it has. What comes in replaces what
/// came before it and was not begun yet; of what goes out only the latest frame is kept, so a slow window
/// skips frames.
class Preview : public QObject {
    Q_OBJECT

public:
    explicit Preview(QObject* parent = nullptr);
    ~Preview() override;

    /// What is said after it waits for it: played and put to rest is this project.
    void setProject(const Project& project);
    /// How many projects have come: each is evaluated once at most.
    int projectCount() const;
    void setPlaying(bool playing);
    /// Whether it plays, or will once the project that came last is prepared.
    bool isToPlay() const;
    /// Pauses what plays or is about to; plays what does not, from rest when the run had failed.
    void togglePlaying();
    void reset();
    /// Plays the loads of the project's scene from rest, and pauses where it ends.
    void playScene();
    /// Goes back to rest, plays, and writes down what the hand does from there on.
    void record();
    /// Whether it does, or is about to. The scene and another net of the organ end it.
    bool isRecording() const;
    /// s that are written down; none while nothing is.
    std::optional<double> recordedTime() const;
    /// What was written down; none where nothing was.
    std::optional<Poke> endRecording();
    void setPull(const std::optional<Pull>& pull);
    void setInstrument(const std::optional<PlacedCollider>& instrument);
    void setGentleMotion(bool on);
    /// What acts on the tissue from now on.
    PreviewLoads loads() const;

    PreviewFrame frame();
    PreviewStatus status() const;
    /// Where the instrument is that the hand leads; none while nothing plays. See PreviewRun.
    std::optional<PlacedCollider> heldInstrument() const;
    /// What the project that came last is made of, evaluated once for all who show it; null while it is
    /// evaluated, and where it cannot be.
    std::shared_ptr<const TissueModel> tissue() const;

signals:
    void frameReady();
    void tissueReady();
    void statusChanged();
    /// Somebody takes hold of the tissue.
    void pullBegan();

private:
    using Preparer = LatestWorker<Project, std::shared_ptr<PreparedProject>>;

    /// Guarded by m_mutex; what the worker has yet to look at.
    struct Inbox {
        std::shared_ptr<PreparedProject> prepared;
        int asked = 0, arrived = 0; ///< numbers of the last project that came and that was prepared
        std::shared_ptr<const SpringNetwork> network; ///< of the last that came
        std::optional<int> reset, playScene, record;  ///< wait for the project of this number
        std::optional<double> safeStep;               ///< s, of what runs
        bool isNew = false, playing = false, stop = false;
        bool isHeldByFailure = false; ///< paused by it: the next project that can run is played
        PreviewLoads loads;
    };

    struct Worker;

    std::shared_ptr<PreparedProject> prepare(const Preparer::Task& task);
    void tellTissue(const std::shared_ptr<const TissueModel>& tissue, int number);
    void takePrepared();
    void work();
    bool workOnce(Worker& worker);
    void take(Worker& worker, PreparedProject prepared);
    /// Seeks the largest stable step of the integrator that runs.
    void gauge(Worker& worker);
    void pauseWhatEnded(Inbox& inbox, bool isSceneOver);
    /// Ends the run for what went wrong outside the simulation.
    void giveUp(PreviewRun& run, const std::string& reason);
    bool advance(PreviewRun& run, const PreviewLoads& loads);
    Inbox collect(bool idle, std::chrono::steady_clock::time_point until);
    void publish(const Worker& worker, int project);
    void takeSafeStep(std::optional<double> step);
    template<typename Change> void send(Change change);

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    Inbox m_inbox;
    PreviewFrame m_frame;
    PreviewStatus m_status;
    std::shared_ptr<const TissueModel> m_tissue;
    std::optional<PokeRecorder> m_recorder;
    int m_tissueProject = 0; ///< the number of the project that it is of
    std::atomic<bool> m_frameAnnounced = false;
    SafeStepFinder m_safeSteps;
    const std::shared_ptr<MatrixFactoriser> m_factoriser; ///< the preparer's
    Preparer m_preparer;
    std::thread m_thread;
};

} // namespace esm
