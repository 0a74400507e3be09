#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/latest_worker.h"
#include "app/editor/workers/preview.h"
#include "core/probing/probe.h"
#include "widgets/view/picking.h"

namespace esm {

/// What a finger met, and how it pressed what.
struct MeasuredPress {
    ProbeSettings settings;
    ProbeResult result;
    std::shared_ptr<const TissueModel> tissue;
};

/// A finger that presses the organ at rest, beside the window: where and how, what it met, and what it met
/// before the tissue was changed. None of it is part of the project.
class VirtualTest : public QObject {
    Q_OBJECT

public:
    using Press = std::shared_ptr<const MeasuredPress>;

    VirtualTest(Document& document, Preview& preview, QObject* parent = nullptr);

    /// Where the finger presses; none before one is chosen, and on another organ.
    const std::optional<CarriedPlace>& place() const { return m_place; }
    void choosePlace(const CarriedPlace& place);
    /// The same on the organ at rest, m.
    std::optional<Eigen::Vector3d> restPlace() const;
    /// All but the place: a finger's tip, or a smaller one that fits a small organ, until the user chooses.
    const ProbeSettings& settings() const { return m_settings; }
    void setRadius(double metres);
    void setDepth(double metres);

    /// Why nothing can be pressed now; empty where it can.
    QString obstacle() const;
    /// Measures, where nothing is in the way; in place of what is being measured.
    void press();
    void cancel();
    bool isPressing() const { return m_isPressing; }
    double progress() const { return m_progress; } ///< 0 to 1, of what is being measured
    /// Why the last test has no result, as the core says it; empty where it has one, or another is wanted.
    const std::string& failure() const { return m_failure; }

    /// What was measured last; null before.
    const Press& latest() const { return m_latest; }
    /// What to compare it with: what was measured before the tissue was changed, by the same finger at the
    /// same place, or what was kept. Null without.
    const Press& former() const { return m_former; }
    /// Whether the organ's tissue is another than that which was measured last.
    bool isOutdated() const { return m_isOutdated; }
    /// From now on what was measured last is compared with, whatever is measured; until forgetFormer().
    void keepLatest();
    void forgetFormer();

signals:
    /// What any of these gives.
    void changed();
    /// On the worker's thread: it has news.
    void told();

private:
    struct Question {
        std::shared_ptr<const TissueModel> tissue;
        std::shared_ptr<const TriangleMesh> mesh;
        ProbeSettings settings;
    };
    /// No question takes the place of one that is no longer of interest.
    using Worker = LatestWorker<std::optional<Question>, Press>;

    Press answerTo(const Worker::Task& task);
    void hear();
    void take(const Press& press);
    void followDocument(const Change& change);
    void followTissue();
    void forget();
    void fitFinger();

    Document& m_document;
    Preview& m_preview;
    std::shared_ptr<const TriangleMesh> m_mesh; ///< that the place lies on
    std::optional<CarriedPlace> m_place;
    ProbeSettings m_settings;
    bool m_isFingerChosen = false; ///< by the user
    Press m_latest, m_former;
    bool m_isKept = false; ///< what is compared with, by the user
    bool m_isOutdated = false, m_isPressing = false;
    int m_asked = 0; ///< the number of the question that is being answered
    std::string m_failure;
    std::atomic<double> m_progress = 0;
    Worker m_worker; ///< last, so that it ends first
};

} // namespace esm
