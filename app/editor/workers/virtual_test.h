#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/compared.h"
#include "app/editor/workers/latest_worker.h"
#include "app/editor/workers/preview.h"
#include "core/probing/strip_frame.h"
#include "widgets/view/picking.h"

#include <array>

namespace esm {

/// What is done to the organ: a finger presses to a depth, presses and stays there, or is pushed with one
/// force; or a strip is cut out and stretched.
enum class TestKind { Press, Stay, Push, Strip };
inline constexpr std::size_t testKinds = 4;

struct MeasuredStrip {
    StripSettings settings;
    StripResult result;
};

/// What a test met, and how it was done to what.
struct MeasuredPress {
    TestKind kind;
    ProbeSettings settings;             ///< of a finger; of a strip the place alone
    ProbeResult result;                 ///< of a finger; nothing of a strip
    std::optional<MeasuredStrip> strip; ///< none of a finger
    std::shared_ptr<const TissueModel> tissue;
    std::optional<double> tissueTime; ///< s, viscosity over spring constant of the tissue at the place

    /// How force or depth go on in time; null of a press.
    const TimeCurve* inTime() const;
};

/// A finger that presses the organ at rest, or a strip of it that is stretched, beside the window: where and
/// how, what it met, and what it met before the tissue was changed, of each kind of test. None of it is part
/// of the project.
class VirtualTest : public QObject {
    Q_OBJECT

public:
    using Press = std::shared_ptr<const MeasuredPress>;

    VirtualTest(Document& document, Preview& preview, QObject* parent = nullptr);

    /// Where the finger presses; none before one is chosen, and on another organ.
    const std::optional<CarriedPlace>& place() const { return m_place; }
    /// @param isSeenFromInside as through the mouth of an open organ
    void choosePlace(const CarriedPlace& place, bool isSeenFromInside = false);
    /// Whether the place was chosen at the wall's inside; it is pressed from outside all the same.
    bool isSeenFromInside() const { return m_place && m_isSeenFromInside; }
    /// The same on the organ at rest, m.
    std::optional<Eigen::Vector3d> restPlace() const;
    /// Which test is measured next, and told of by all below.
    TestKind kind() const { return m_kind; }
    void chooseKind(TestKind kind);
    /// Radius and depth: of a finger's tip, or of a smaller one that fits a small organ, until the user
    /// chooses.
    const ProbeSettings& settings() const { return m_settings; }
    void setRadius(double metres);
    void setDepth(double metres);
    /// N, with which it is pushed: what the last press met, until the user chooses.
    double force() const { return m_force; }
    void setForce(double newtons);
    double duration() const { return m_duration; } ///< s, of a test in time
    void setDuration(double seconds);
    /// Of a strip, all but its place: of a size that fits the organ until the user chooses.
    const StripSettings& stripSettings() const { return m_strip; }
    void setStripLength(double metres);
    void setStripWidth(double metres);
    void setStretch(double share);
    void setTurn(double degrees);
    /// How it lies on the organ at rest; none without a place.
    const std::optional<StripFrame>& stripFrame() const { return m_stripFrame; }

    /// Why nothing can be pressed now; empty where it can.
    QString obstacle() const;
    /// Measures, where nothing is in the way; in place of what is being measured.
    void press();
    void cancel();
    bool isPressing() const { return m_isPressing; }
    double progress() const { return m_progress; } ///< 0 to 1, of what is being measured
    /// Why the last test has no result, as the core says it; empty where it has one, or another is wanted.
    const std::string& failure() const { return shown().failure; }

    /// What was measured last; null before.
    const Press& latest() const { return shown().latest; }
    /// What to compare it with: what was measured before the tissue was changed, by the same finger at the
    /// same place, or what was kept. Null without.
    const Press& former() const { return shown().former; }
    /// Whether the organ's tissue is another than that which was measured last.
    bool isOutdated() const;
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
        TestKind kind;
        std::shared_ptr<const TissueModel> tissue;
        std::shared_ptr<const TriangleMesh> mesh;
        ProbeSettings settings;
        StripSettings strip;
    };
    /// No question takes the place of one that is no longer of interest.
    using Worker = LatestWorker<std::optional<Question>, Press>;

    using Measured = Compared<MeasuredPress>;

    Measured& of(TestKind kind) { return m_measured.at(static_cast<std::size_t>(kind)); }
    const Measured& shown() const { return m_measured.at(static_cast<std::size_t>(m_kind)); }
    bool isOfAnotherWall(const MeasuredPress& press) const;
    ProbeSettings wantedSettings() const;
    Press answerTo(const Worker::Task& task);
    void hear();
    void take(const Press& press);
    void followDocument(const Change& change);
    void followTissue();
    void forget();
    void fitFinger();
    void fitStrip();
    void layStrip();
    void tellChoice();

    Document& m_document;
    Preview& m_preview;
    std::shared_ptr<const TriangleMesh> m_mesh; ///< that the place lies on
    std::optional<CarriedPlace> m_place;
    bool m_isSeenFromInside = false;
    ProbeSettings m_settings;
    StripSettings m_strip;
    std::optional<StripFrame> m_stripFrame;
    TestKind m_kind = TestKind::Press;
    double m_force, m_duration;
    bool m_isFingerChosen = false, m_isForceChosen = false, m_isStripChosen = false; ///< by the user
    std::array<Measured, testKinds> m_measured;                                      ///< by their kind
    bool m_isPressing = false;
    int m_asked = 0;                        ///< the number of the question that is being answered
    TestKind m_askedKind = TestKind::Press; ///< of that question
    std::atomic<double> m_progress = 0;
    Worker m_worker; ///< last, so that it ends first
};

} // namespace esm
