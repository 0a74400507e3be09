#include "app/editor/workers/poke_test.h"

#include "app/editor/workers/told_progress.h"
#include "core/model/scene_events.h"

#include <algorithm>

namespace esm {

namespace {

constexpr int recordingNews = 50; // ms

/// Whether the hand does anything to the organ.
bool touches(const Poke& poke) {
    return std::any_of(poke.moments.begin(), poke.moments.end(),
                       [](const HandMoment& moment) { return moment.loads.pull || moment.loads.instrument; });
}

/// Whether the same holds an organ, or acts on it all the time. A poke knows no more of a scene.
bool holdAlike(const Scene& a, const Scene& b) {
    const Scene held = withoutEvents(a);
    Scene other = withoutEvents(b);
    other.duration = held.duration;
    other.record = held.record;
    return held == other;
}

/// Whether both move alike under the same poke.
bool movesAlike(const Project& a, const Project& b) {
    Change change = difference(a, b);
    change.scene = !holdAlike(a.scene, b.scene);
    return !change.model() && !change.stepping;
}

} // namespace

PokeTest::PokeTest(Document& document, Preview& preview, QObject* parent)
    : QObject(parent), m_document(document), m_preview(preview),
      m_worker([this](const Worker::Task& task) { return answerTo(task); }, [this] { emit told(); }) {
    connect(this, &PokeTest::told, this, &PokeTest::hear, Qt::QueuedConnection);
    connect(&document, &Document::changed, this, &PokeTest::followDocument);
    connect(&document, &Document::replaced, this, &PokeTest::forget);
    m_recording.setInterval(recordingNews);
    connect(&m_recording, &QTimer::timeout, this, &PokeTest::followRecording);
}

void PokeTest::record() {
    cancel();
    m_player.leave();
    m_motions.failure.clear();
    m_preview.record();
    m_recording.start();
    emit recordingBegan();
    emit changed();
}

double PokeTest::recordedTime() const {
    return m_preview.recordedTime().value_or(0);
}

void PokeTest::followRecording() {
    if (recordedTime() >= longestPoke || !m_preview.isRecording()) return stop();
    emit changed();
}

void PokeTest::stop() {
    if (!isRecording()) return;
    m_recording.stop();
    const bool hasEnded = !m_preview.isRecording();
    const std::optional<Poke> poke = m_preview.endRecording();
    if (hasEnded)
        m_motions.failure = tr("the recording ended because the organ was reset or moved in a scene: record "
                               "again")
                                .toStdString();
    else if (!poke || !touches(*poke))
        m_motions.failure =
            tr("your hand touched nothing: pull or push the organ while it is recorded").toStdString();
    else
        takePoke(*poke);
    emit changed();
}

void PokeTest::takePoke(const Poke& poke) {
    m_poke = poke;
    m_pokedMesh = m_document.project().mesh;
    m_motions.latest.reset();
    if (!m_motions.isKept) m_motions.former.reset();
    fitPlayer();
    repeat();
}

QString PokeTest::obstacle() const {
    if (isRecording()) return tr("The poke is being recorded");
    if (!m_poke) return tr("Record a poke first");
    if (!m_preview.status().failure.empty())
        return tr("The tissue cannot move: the line at the bottom says why");
    return {};
}

void PokeTest::repeat() {
    if (!obstacle().isEmpty()) return;
    m_motions.failure.clear();
    m_progress = 0;
    m_isComputing = true;
    m_asked = m_worker.ask(Question{*m_poke, m_document.project()});
    emit changed();
}

void PokeTest::cancel() {
    if (!m_isComputing) return;
    m_isComputing = false;
    m_worker.ask(std::nullopt);
    emit changed();
}

PokeTest::Motion PokeTest::answerTo(const Worker::Task& task) {
    if (!task.question) return nullptr;
    const Progress progress = toldProgress(task.progress(), m_progress, [this] { emit told(); });
    return std::make_shared<const PokeMotion>(
        motionUnder(task.question->poke, task.question->project, progress));
}

void PokeTest::hear() {
    if (!m_isComputing) return;
    const Outcome<Motion> outcome = m_worker.outcome();
    if (outcome.number == m_asked) {
        m_isComputing = false;
        m_motions.failure = outcome.failure;
        if (m_motions.failure.empty()) take(outcome.answer);
    }
    emit changed();
}

/// Two curves in one plot are to differ by the organ alone, unless the user chose what to compare with.
void PokeTest::take(const Motion& motion) {
    if (!m_motions.isKept && m_motions.latest && !movesAlike(m_motions.latest->project, motion->project))
        m_motions.former = m_motions.latest;
    m_motions.latest = motion;
    m_motions.isOutdated = !movesAlike(motion->project, m_document.project());
    fitPlayer();
}

/// Nothing can be shown on an organ of other nodes.
void PokeTest::fitPlayer() {
    double duration = 0;
    if (m_motions.latest && m_motions.latest->project.network == m_document.project().network)
        for (const Motion& motion : {m_motions.latest, m_motions.former})
            if (motion) duration = std::max(duration, motion->pictures.back().time);
    if (duration != m_player.duration()) m_player.setDuration(duration);
}

void PokeTest::keepLatest() {
    m_motions.keepLatest();
    emit changed();
}

void PokeTest::forgetFormer() {
    m_motions.forgetFormer();
    fitPlayer();
    emit changed();
}

/// Another net of the same surface is still the organ that was poked.
void PokeTest::followDocument(const Change& change) {
    const bool interrupts = change.mesh && isRecording();
    m_motions.failure.clear(); // what is said now is what to do after the change
    if (m_poke && m_pokedMesh != m_document.project().mesh) forget();
    if (m_motions.latest) m_motions.isOutdated = !movesAlike(m_motions.latest->project, m_document.project());
    if (interrupts) {
        m_recording.stop();
        m_preview.endRecording();
        m_motions.failure =
            tr("the recording ended because the organ got another shape or other nodes: record again")
                .toStdString();
    }
    fitPlayer();
    emit changed();
}

void PokeTest::forget() {
    cancel();
    m_preview.endRecording();
    m_recording.stop();
    m_poke.reset();
    m_motions = {};
    fitPlayer();
    emit changed();
}

} // namespace esm
