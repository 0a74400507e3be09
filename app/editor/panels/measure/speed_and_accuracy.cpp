#include "app/editor/panels/measure/speed_and_accuracy.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/split_question.h"
#include "app/editor/edits/simulated_edit.h"
#include "core/authoring/accuracy.h"
#include "core/model/tissue_digest.h"

namespace esm {

namespace {

/// To digest the tissue at every step of a drag would hold the drag up.
constexpr int restBeforeComparing = 300; // ms

/// The tissue rests meanwhile: its motion would take time from what is measured.
class Pause {
public:
    explicit Pause(Preview& preview) : m_preview(preview), m_wasPlaying(preview.isToPlay()) {
        m_preview.setPlaying(false);
    }
    ~Pause() { m_preview.setPlaying(m_wasPlaying); }
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

private:
    Preview& m_preview;
    bool m_wasPlaying;
};

} // namespace

SpeedAndAccuracy::SpeedAndAccuracy(Document& document, Preview& preview, QObject* parent)
    : QObject(parent), m_document(document), m_preview(preview) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(restBeforeComparing);
    connect(&m_rest, &QTimer::timeout, this, &SpeedAndAccuracy::compare);
    connect(&preview, &Preview::tissueReady, &m_rest, qOverload<>(&QTimer::start));
    connect(&document, &Document::changed, this, &SpeedAndAccuracy::follow);
    connect(&document, &Document::replaced, this, [this] {
        m_isOutdated = false; // of another organ nothing is known yet
        emit changed();
    });
    workOut();
    m_rest.start();
}

void SpeedAndAccuracy::follow(const Change& change) {
    if (!change.model() && !change.stepping && !change.accuracy) return;
    m_rest.start();
    if (change.accuracy) {
        workOut();
        emit runsChanged();
    }
    emit changed();
}

void SpeedAndAccuracy::workOut() {
    const auto& accuracy = m_document.project().accuracy;
    m_tradeoff = accuracy ? std::optional(tradeoffOf(*accuracy, m_wishes)) : std::nullopt;
}

void SpeedAndAccuracy::setMostError(double error) {
    m_wishes.mostError = error;
    workOut();
    emit changed();
}

// Until the tissue is evaluated, what was said before stays; where it cannot be, the preview says what is
// wrong.
void SpeedAndAccuracy::compare() {
    const Project& project = m_document.project();
    if (const std::shared_ptr<const TissueModel> tissue = m_preview.tissue()) {
        const bool isOther = project.stepping && isFromOtherTissue(*project.stepping, *tissue);
        m_isOutdated =
            isOther || (project.accuracy && !isMeasuredOn(project, {tissueDigest(*tissue), project.scene}));
    }
    emit changed();
}

std::optional<std::size_t> SpeedAndAccuracy::runInUse() const {
    const Project& project = m_document.project();
    if (!m_tradeoff || !project.stepping) return std::nullopt;
    const auto& runs = m_tradeoff->runs;
    const auto found = std::find_if(runs.begin(), runs.end(), [&](const TradeoffRun& run) {
        return run.nodes == project.network->restPositions.size() &&
               run.stepping == project.stepping->stepping;
    });
    return found == runs.end() ? std::nullopt : std::optional<std::size_t>(found - runs.begin());
}

void SpeedAndAccuracy::measure(QWidget* window) {
    const Project project = m_document.project();
    TradeoffOptions options;
    options.mostSecondsPerRun = m_mostSecondsPerRun;
    options.wishes = m_wishes;
    attempt(window, tr("Speed and accuracy cannot be measured"), [&] {
        const Pause pause(m_preview);
        const Project measured = computeLong(
            window, tr("Measuring speed and accuracy"),
            [&](const Progress& progress) {
                return withAccuracy(project, project.scene, measureAccuracy(project, options, progress));
            },
            Cancelling::Offered);
        m_document.edit(tr("Measure speed and accuracy"),
                        [&](Project& edited) { edited.accuracy = measured.accuracy; });
    });
}

void SpeedAndAccuracy::use(std::size_t run, QWidget* window) {
    const Project project = m_document.project();
    const bool isOnOtherNodes = m_tradeoff->runs[run].nodes != project.network->restPositions.size();
    if (isOnOtherNodes && !mayRemoveSplits(*window, project.scene)) return;
    attempt(window, tr("This run cannot be used"), [&] {
        const Project changed = computeLong(
            window, tr("Choosing method and step"),
            [&](const Progress& progress) { return withMeasuredRun(project, run, progress); },
            Cancelling::Offered);
        m_document.edit(tr("Choose method and step"),
                        [&](Project& edited) { takeSimulated(edited, changed); });
    });
}

void SpeedAndAccuracy::useAutomatic() {
    m_document.edit(tr("Choose method and step"), [](Project& project) { project.stepping.reset(); });
}

} // namespace esm
