#include "app/editor/workers/virtual_test.h"

#include "app/editor/workers/told_progress.h"
#include "core/dynamics/contact/touched_surface.h"
#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double samePlace = 1e-9;  ///< m
constexpr double roundTo = 5e-5;    ///< m, of a finger that is made to fit
constexpr double nodesAcross = 3.5; ///< at least, of a strip that is made to fit
constexpr double firstForce = 0.05; ///< N, before anything was pressed
constexpr double firstDuration = 2; ///< s; dents of soft organs take this long
/// Of the radius: so deep a finger goes first that is then pushed with a force, whatever depth that leads to.
constexpr double touchShare = 0.02;
constexpr int forceDigits = 2; ///< of a force that is taken over from a press

/// Whether springs resist the same at rest, where no damper bears anything.
bool resistAlike(const std::vector<SpringValues>& a, const std::vector<SpringValues>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const SpringValues& x, const SpringValues& y) { return x.springConstant == y.springConstant; });
}

/// Whether strips of both stretch alike, that nothing holds.
bool stretchAlike(const TissueModel& a, const TissueModel& b) {
    return a.network == b.network && a.springConstant == b.springConstant && a.stiffening == b.stiffening &&
           resistAlike(a.ownValues, b.ownValues) && a.hinges == b.hinges;
}

/// Whether a finger meets the same within, whatever a scene goes on to press with.
bool pressAlike(const std::vector<Cavity>& a, const std::vector<Cavity>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Cavity& x, const Cavity& y) {
        return x.part == y.part && x.stiffness == y.stiffness && x.initialPressure == y.initialPressure &&
               x.triangles == y.triangles;
    });
}

/// Whether a test meets the same in both. What takes no part at rest may differ, but for tests in time.
bool meetAlike(TestKind kind, const TissueModel& a, const TissueModel& b) {
    if (&a == &b) return true;
    if (kind == TestKind::Strip) return stretchAlike(a, b);
    const bool restsAlike = stretchAlike(a, b) && a.fixedNodes == b.fixedNodes && a.tethers == b.tethers &&
                            pressAlike(a.cavities, b.cavities);
    return restsAlike && (kind == TestKind::Press ||
                          (a.mass == b.mass && a.viscosity == b.viscosity && a.ownValues == b.ownValues));
}

bool isSameStrip(const StripSettings& a, const StripSettings& b) {
    return a.length == b.length && a.width == b.width && a.along == b.along;
}

/// Whether two tests can differ by the tissue alone. Curves of force over depth, or over elongation, go on
/// alike, however far.
bool isSameTest(const MeasuredPress& a, const MeasuredPress& b) {
    if ((a.settings.place - b.settings.place).norm() >= samePlace) return false;
    if (a.strip) return isSameStrip(a.strip->settings, b.strip->settings);
    if (a.settings.radius != b.settings.radius) return false;
    if (a.kind == TestKind::Stay) return a.settings.depth == b.settings.depth;
    return a.kind != TestKind::Push || a.settings.creep->force == b.settings.creep->force;
}

double rounded(double value, int digits) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - digits + 1);
    return std::round(value / unit) * unit;
}

/// m, at rest; 0 without springs.
double meanLength(const std::vector<Spring>& springs) {
    double sum = 0;
    for (const Spring& spring : springs)
        sum += spring.restLength / static_cast<double>(springs.size());
    return sum;
}

/// Of the node nearest to a place, s. None of tissue without a spring constant.
std::optional<double> tissueTimeAt(const TissueModel& tissue, const Eigen::Vector3d& place) {
    const auto& nodes = tissue.network->restPositions;
    const auto isNearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a - place).squaredNorm() < (b - place).squaredNorm();
    };
    const auto node = static_cast<std::size_t>(
        std::distance(nodes.begin(), std::min_element(nodes.begin(), nodes.end(), isNearer)));
    if (!(tissue.springConstant[node] > 0)) return std::nullopt;
    return tissue.viscosity[node] / tissue.springConstant[node];
}

} // namespace

const TimeCurve* MeasuredPress::inTime() const {
    if (result.relaxation) return &*result.relaxation;
    return result.creep ? &*result.creep : nullptr;
}

VirtualTest::VirtualTest(Document& document, Preview& preview, QObject* parent)
    : QObject(parent), m_document(document), m_preview(preview), m_mesh(document.project().mesh),
      m_force(firstForce), m_duration(firstDuration),
      m_worker([this](const Worker::Task& task) { return answerTo(task); }, [this] { emit told(); }) {
    connect(this, &VirtualTest::told, this, &VirtualTest::hear, Qt::QueuedConnection);
    connect(&document, &Document::changed, this, &VirtualTest::followDocument);
    connect(&document, &Document::replaced, this, &VirtualTest::forget);
    connect(&preview, &Preview::tissueReady, this, &VirtualTest::followTissue);
    fitFinger();
    fitStrip();
}

void VirtualTest::choosePlace(const CarriedPlace& place, bool isSeenFromInside) {
    m_place = place;
    m_isSeenFromInside = isSeenFromInside;
    layStrip();
    tellChoice();
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

/// A third as wide as long: at most of the usual length, or an eighth of the organ's diagonal where that is
/// less, but of a few nodes across.
void VirtualTest::fitStrip() {
    if (m_isStripChosen) return;
    const Project& project = m_document.project();
    const double size = organBox(*project.mesh, *project.network).diagonal().norm();
    const double least = std::min(3 * nodesAcross * meanLength(project.network->springs), size / 3);
    const double length = std::max(std::min(size / 8, StripSettings().length), least);
    m_strip.length = std::max(std::round(length / 3 / roundTo), 1.0) * 3 * roundTo;
    m_strip.width = m_strip.length / 3;
}

void VirtualTest::layStrip() {
    m_stripFrame.reset();
    const TriangleMesh& mesh = *m_document.project().mesh;
    if (!m_place || mesh.triangles.empty()) return;
    const Eigen::Vector3d across = areaNormal(mesh.vertices, m_place->corners);
    if (across.norm() > 0)
        m_stripFrame = esm::stripFrame(mesh, {*restPlace(), across.stableNormalized()}, m_strip);
}

void VirtualTest::setStripLength(double metres) {
    m_isStripChosen = true;
    m_strip.length = metres;
    tellChoice();
}

void VirtualTest::setStripWidth(double metres) {
    m_isStripChosen = true;
    m_strip.width = metres;
    layStrip();
    tellChoice();
}

void VirtualTest::setStretch(double share) {
    m_strip.stretch = share;
    tellChoice();
}

void VirtualTest::setTurn(double degrees) {
    m_strip.turn = toRadians(degrees);
    layStrip();
    tellChoice();
}

void VirtualTest::setRadius(double metres) {
    m_isFingerChosen = true;
    m_settings.radius = metres;
    tellChoice();
}

void VirtualTest::setDepth(double metres) {
    m_isFingerChosen = true;
    m_settings.depth = metres;
    tellChoice();
}

/// What failed may go well now.
void VirtualTest::tellChoice() {
    for (Measured& measured : m_measured)
        measured.failure.clear();
    emit changed();
}

void VirtualTest::chooseKind(TestKind kind) {
    if (kind == m_kind) return;
    m_kind = kind;
    emit changed();
}

void VirtualTest::setForce(double newtons) {
    m_isForceChosen = true;
    m_force = newtons;
    tellChoice();
}

void VirtualTest::setDuration(double seconds) {
    m_duration = seconds;
    tellChoice();
}

QString VirtualTest::obstacle() const {
    if (!m_place) return tr("Choose a place on the organ first");
    if (m_preview.tissue()) return {};
    return m_preview.status().failure.empty()
               ? tr("The tissue is being evaluated")
               : tr("The tissue cannot be evaluated: the line at the bottom says why");
}

ProbeSettings VirtualTest::wantedSettings() const {
    ProbeSettings settings = m_settings;
    settings.place = *restPlace();
    if (m_kind == TestKind::Stay) settings.relaxation = RelaxationTest{m_duration};
    if (m_kind == TestKind::Push) {
        settings.depth = touchShare * settings.radius;
        settings.steps = 1;
        settings.creep = CreepTest{m_force, m_duration};
    }
    return settings;
}

void VirtualTest::press() {
    if (!obstacle().isEmpty()) return;
    Question question{m_kind, m_preview.tissue(), m_document.project().mesh, wantedSettings(), m_strip};
    question.strip.place = question.settings.place;
    question.strip.wallThickness = m_document.project().base.wallThickness;
    if (m_stripFrame) { // as it is drawn, however the nodes beneath lie
        question.strip.along = m_stripFrame->along;
        question.strip.turn = 0;
    }
    of(m_kind).failure.clear();
    m_progress = 0;
    m_isPressing = true;
    m_askedKind = m_kind;
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
    const auto& [kind, tissue, mesh, settings, strip] = *task.question;
    const TouchedSurface surface = touchedSurface(*mesh, *tissue->network);
    const Progress progress = toldProgress(task.progress(), m_progress, [this] { emit told(); });
    if (kind == TestKind::Strip)
        return std::make_shared<const MeasuredPress>(
            MeasuredPress{kind,
                          settings,
                          {},
                          MeasuredStrip{strip, pullStrip({*tissue, surface}, strip, progress)},
                          tissue,
                          {}});
    ProbeResult result = probe({*tissue, surface}, settings, progress);
    const std::optional<double> time = tissueTimeAt(*tissue, result.place);
    return std::make_shared<const MeasuredPress>(
        MeasuredPress{kind, settings, std::move(result), {}, tissue, time});
}

void VirtualTest::hear() {
    if (!m_isPressing) return;
    const Outcome<Press> outcome = m_worker.outcome();
    if (outcome.number == m_asked) {
        m_isPressing = false;
        of(m_askedKind).failure = outcome.failure;
        if (outcome.failure.empty()) take(outcome.answer);
    }
    emit changed();
}

/// Two curves in one plot are to differ by one thing: the tissue, unless the user chose what to compare with.
void VirtualTest::take(const Press& press) {
    Measured& measured = of(press->kind);
    if (!measured.isKept) {
        if (!measured.latest || !isSameTest(*measured.latest, *press))
            measured.former.reset();
        else if (!meetAlike(press->kind, *measured.latest->tissue, *press->tissue))
            measured.former = measured.latest;
    }
    measured.latest = press;
    const std::shared_ptr<const TissueModel> now = m_preview.tissue();
    measured.isOutdated = now && !meetAlike(press->kind, *press->tissue, *now);
    if (press->kind == TestKind::Push || press->strip || m_isForceChosen) return;
    const double met = press->result.curve.back().force;
    if (met > 0) m_force = rounded(met, forceDigits);
}

void VirtualTest::keepLatest() {
    of(m_kind).keepLatest();
    emit changed();
}

void VirtualTest::forgetFormer() {
    of(m_kind).forgetFormer();
    emit changed();
}

/// A place stays on the same corners of another shape of the same organ, and of another net in it.
void VirtualTest::followDocument(const Change& change) {
    if (!change.mesh) return emit changed(); // the wall's thickness may be another
    const std::shared_ptr<const TriangleMesh> mesh = m_document.project().mesh;
    const bool isSame = !mesh->triangles.empty() && mesh->vertices.size() == m_mesh->vertices.size() &&
                        mesh->triangles == m_mesh->triangles;
    m_mesh = mesh;
    if (!isSame) return forget();
    fitStrip();
    layStrip();
}

/// Its thickness takes no part in what is measured, but in the modulus of a strip of it.
bool VirtualTest::isOfAnotherWall(const MeasuredPress& press) const {
    return press.strip && !press.tissue->network->lattice &&
           press.strip->settings.wallThickness != m_document.project().base.wallThickness;
}

bool VirtualTest::isOutdated() const {
    return shown().isOutdated || (latest() && isOfAnotherWall(*latest()));
}

void VirtualTest::followTissue() {
    const std::shared_ptr<const TissueModel> now = m_preview.tissue();
    for (Measured& measured : m_measured)
        if (now && measured.latest)
            measured.isOutdated = !meetAlike(measured.latest->kind, *measured.latest->tissue, *now);
    emit changed();
}

void VirtualTest::forget() {
    cancel();
    m_place.reset();
    m_measured = {};
    if (!m_isForceChosen) m_force = firstForce;
    fitFinger();
    m_isStripChosen = false; // its size fits no other organ
    fitStrip();
    layStrip();
    emit changed();
}

} // namespace esm
