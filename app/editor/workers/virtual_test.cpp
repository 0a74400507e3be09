#include "app/editor/workers/virtual_test.h"

#include "core/dynamics/contact/touched_surface.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double toldShare = 0.01; ///< of the work, after which a window hears of it again
constexpr double samePlace = 1e-9; ///< m
constexpr double roundTo = 5e-5;   ///< m, of a finger that is made to fit

/// Whether a finger meets the same in both. What takes no part at rest may differ.
bool pressesAlike(const TissueModel& a, const TissueModel& b) {
    if (&a == &b) return true;
    return a.network == b.network && a.springConstant == b.springConstant && a.stiffening == b.stiffening &&
           a.fixedNodes == b.fixedNodes && a.ownValues == b.ownValues && a.tethers == b.tethers &&
           a.hinges == b.hinges && a.cavities.size() == b.cavities.size();
}

/// Whether two tests can differ by the tissue alone.
bool isSameTest(const ProbeSettings& a, const ProbeSettings& b) {
    return (a.place - b.place).norm() < samePlace && a.radius == b.radius;
}

} // namespace

VirtualTest::VirtualTest(Document& document, Preview& preview, QObject* parent)
    : QObject(parent), m_document(document), m_preview(preview), m_mesh(document.project().mesh),
      m_worker([this](const Worker::Task& task) { return answerTo(task); }, [this] { emit told(); }) {
    connect(this, &VirtualTest::told, this, &VirtualTest::hear, Qt::QueuedConnection);
    connect(&document, &Document::changed, this, &VirtualTest::followDocument);
    connect(&document, &Document::replaced, this, &VirtualTest::forget);
    connect(&preview, &Preview::tissueReady, this, &VirtualTest::followTissue);
    fitFinger();
}

void VirtualTest::choosePlace(const CarriedPlace& place) {
    m_place = place;
    m_failure.clear();
    emit changed();
}

std::optional<Eigen::Vector3d> VirtualTest::restPlace() const {
    if (!m_place) return std::nullopt;
    const Project& project = m_document.project();
    return pointOf(*m_place,
                   project.mesh->triangles.empty() ? project.network->restPositions : project.mesh->vertices);
}

/// A twentieth of the organ's diagonal where that is less than a fingertip, to a twentieth of a millimetre.
void VirtualTest::fitFinger() {
    if (m_isFingerChosen) return;
    const Project& project = m_document.project();
    const double fitting = organBox(*project.mesh, *project.network).diagonal().norm() / 20;
    const double radius = std::max(std::round(fitting / roundTo), 1.0) * roundTo;
    m_settings.radius = std::min(radius, ProbeSettings().radius);
    m_settings.depth = m_settings.radius / 2;
}

void VirtualTest::setRadius(double metres) {
    m_isFingerChosen = true;
    m_settings.radius = metres;
    m_failure.clear();
    emit changed();
}

void VirtualTest::setDepth(double metres) {
    m_isFingerChosen = true;
    m_settings.depth = metres;
    m_failure.clear();
    emit changed();
}

QString VirtualTest::obstacle() const {
    if (!m_place) return tr("Choose a place on the organ first");
    if (m_preview.tissue()) return {};
    return m_preview.status().failure.empty()
               ? tr("The tissue is being evaluated")
               : tr("The tissue cannot be evaluated: the line at the bottom says why");
}

void VirtualTest::press() {
    if (!obstacle().isEmpty()) return;
    Question question{m_preview.tissue(), m_document.project().mesh, m_settings};
    question.settings.place = *restPlace();
    m_failure.clear();
    m_progress = 0;
    m_isPressing = true;
    m_asked = m_worker.ask(std::move(question));
    emit changed();
}

void VirtualTest::cancel() {
    if (!m_isPressing) return;
    m_isPressing = false;
    m_worker.ask(std::nullopt);
    emit changed();
}

VirtualTest::Press VirtualTest::answerTo(const Worker::Task& task) {
    if (!task.question) return nullptr;
    const auto& [tissue, mesh, settings] = *task.question;
    const TouchedSurface surface = touchedSurface(*mesh, *tissue->network);
    const Progress goesOn = task.progress();
    double said = 0;
    const Progress progress = [&](double done) {
        if (!goesOn(done)) return false; // the bar is another question's by now
        if (done >= said + toldShare) {
            said = done;
            m_progress = done;
            emit told();
        }
        return true;
    };
    return std::make_shared<const MeasuredPress>(
        MeasuredPress{settings, probe({*tissue, surface}, settings, progress), tissue});
}

void VirtualTest::hear() {
    if (!m_isPressing) return;
    const Outcome<Press> outcome = m_worker.outcome();
    if (outcome.number == m_asked) {
        m_isPressing = false;
        m_failure = outcome.failure;
        if (m_failure.empty()) take(outcome.answer);
    }
    emit changed();
}

/// Two curves in one plot are to differ by one thing: the tissue, unless the user chose what to compare with.
void VirtualTest::take(const Press& press) {
    if (!m_isKept) {
        if (!m_latest || !isSameTest(m_latest->settings, press->settings))
            m_former.reset();
        else if (!pressesAlike(*m_latest->tissue, *press->tissue))
            m_former = m_latest;
    }
    m_latest = press;
    const std::shared_ptr<const TissueModel> now = m_preview.tissue();
    m_isOutdated = now && !pressesAlike(*press->tissue, *now);
}

void VirtualTest::keepLatest() {
    m_former = m_latest;
    m_isKept = m_former != nullptr;
    emit changed();
}

void VirtualTest::forgetFormer() {
    m_former.reset();
    m_isKept = false;
    emit changed();
}

/// A place stays on the same corners of another shape of the same organ, and of another net in it.
void VirtualTest::followDocument(const Change& change) {
    if (!change.mesh) return;
    const std::shared_ptr<const TriangleMesh> mesh = m_document.project().mesh;
    const bool isSame = !mesh->triangles.empty() && mesh->vertices.size() == m_mesh->vertices.size() &&
                        mesh->triangles == m_mesh->triangles;
    m_mesh = mesh;
    if (!isSame) forget();
}

void VirtualTest::followTissue() {
    const std::shared_ptr<const TissueModel> now = m_preview.tissue();
    if (now) m_isOutdated = m_latest && !pressesAlike(*m_latest->tissue, *now);
    emit changed();
}

void VirtualTest::forget() {
    cancel();
    m_place.reset();
    m_latest.reset();
    m_former.reset();
    m_failure.clear();
    m_isKept = m_isOutdated = false;
    fitFinger();
    emit changed();
}

} // namespace esm
