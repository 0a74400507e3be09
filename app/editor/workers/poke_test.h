#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/compared.h"
#include "app/editor/workers/latest_worker.h"
#include "app/editor/workers/poke_motion.h"
#include "app/editor/workers/poke_player.h"
#include "app/editor/workers/preview.h"

namespace esm {

/// A poke that the hand made once and every later tissue is given: how the organ moves under it now, and how
/// it moved before the tissue was changed, both computed beside the window. None of it is part of the
/// project.
class PokeTest : public QObject {
    Q_OBJECT

public:
    using Motion = std::shared_ptr<const PokeMotion>;

    PokeTest(Document& document, Preview& preview, QObject* parent = nullptr);

    /// Brings the organ to rest and writes down what the hand does, until stop() or for `longestPoke`.
    void record();
    /// Ends it and computes the motion. Where the hand touched nothing, or the recording ended on the way,
    /// the poke before stays and failure() says why.
    void stop();
    bool isRecording() const { return m_recording.isActive(); }
    double recordedTime() const; ///< s, so far
    const std::optional<Poke>& poke() const { return m_poke; }

    /// Why the poke cannot be given again now; empty where it can.
    QString obstacle() const;
    /// Gives the organ the poke as it is now, where nothing is in the way.
    void repeat();
    void cancel();
    bool isComputing() const { return m_isComputing; }
    double progress() const { return m_progress; } ///< 0 to 1, of what is being computed
    /// Why the last try has no motion, as the core says it; empty where it has one.
    const std::string& failure() const { return m_motions.failure; }

    /// How the organ moved last; null before.
    const Motion& latest() const { return m_motions.latest; }
    /// What to compare it with: how it moved under the same poke before it was changed, or what was kept.
    const Motion& former() const { return m_motions.former; }
    /// Whether the organ is another than that which was poked last.
    bool isOutdated() const { return m_motions.isOutdated; }
    /// From now on the last motion is compared with, until forgetFormer().
    void keepLatest();
    void forgetFormer();

    PokePlayer& player() { return m_player; }

signals:
    /// From now on the hand is followed.
    void recordingBegan();
    /// What any of these gives, but the player.
    void changed();
    /// On the worker's thread: it has news.
    void told();

private:
    struct Question {
        Poke poke;
        Project project;
    };
    /// No question takes the place of one that is no longer of interest.
    using Worker = LatestWorker<std::optional<Question>, Motion>;

    Motion answerTo(const Worker::Task& task);
    void hear();
    void takePoke(const Poke& poke);
    void take(const Motion& motion);
    void followRecording();
    void followDocument(const Change& change);
    void forget();
    void fitPlayer();

    Document& m_document;
    Preview& m_preview;
    std::optional<Poke> m_poke;
    std::shared_ptr<const TriangleMesh> m_pokedMesh; ///< the surface of the organ that was poked
    Compared<PokeMotion> m_motions;
    bool m_isComputing = false;
    int m_asked = 0; ///< the number of the question that is being answered
    std::atomic<double> m_progress = 0;
    QTimer m_recording; ///< runs while the hand is recorded
    PokePlayer m_player;
    Worker m_worker; ///< last, so that it ends first
};

} // namespace esm
