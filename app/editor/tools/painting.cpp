#include "app/editor/tools/painting.h"

#include "app/editor/document/project_command.h"
#include "core/texture/layers/covering_layer.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <utility>

namespace esm {

namespace {

/// Share of the radius that points of a path keep between them: the brush joins them by straight lines.
constexpr double pointSpacing = 0.25;

/// Share of the size that the lightest touch of a pen has.
constexpr double leastSize = 0.1;

/// Whether a point is too close to a stroke's last one to be kept.
bool isClose(const BrushPoint& point, const BrushStroke& stroke) {
    const double share = stroke.shares.empty() ? 1 : std::max(leastSize, stroke.shares.back().radius);
    return (point.place - stroke.path.back().place).norm() < pointSpacing * share * stroke.radius;
}

/// False where the pen does not.
bool pressHarder(BrushShares& shares, const BrushShares& now) {
    const BrushShares before = shares;
    shares = {std::max(before.radius, now.radius), std::max(before.strength, now.strength)};
    return shares != before;
}

QString stepName(BrushKind kind) {
    switch (kind) {
    case BrushKind::Erase:
        return Painting::tr("Erase with the brush");
    case BrushKind::Restore:
        return Painting::tr("Restore with the brush");
    case BrushKind::Colour:
        return Painting::tr("Paint with the brush");
    case BrushKind::Clone:
        return Painting::tr("Clone with the brush");
    case BrushKind::Heal:
        return Painting::tr("Heal with the brush");
    }
    return {};
}

/// A twenty-fifth of the organ's diagonal, to half a millimetre where that is fine enough.
double fittingRadius(const TriangleMesh& mesh) {
    constexpr double half = 0.0005; // m
    const double part = 0.04 * boundingBox(mesh.vertices).diagonal().norm();
    const double radius = part > 10 * half ? half * std::round(part / half) : part;
    return std::clamp(radius, texture_limits::shortestPhoto, texture_limits::longestPhoto);
}

} // namespace

Painting::Painting(Document& document, Selection& selection, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection) {
    m_brush.colour = {150, 40, 40};
    connect(&document, &Document::changed, this, &Painting::follow);
    connect(&selection, &Selection::changed, this, &Painting::changed);
    follow(Change::everything());
}

void Painting::follow(const Change& change) {
    if (change.mesh) {
        const TriangleMesh& mesh = *m_document.project().mesh;
        if (!mesh.vertices.empty()) m_brush.radius = fittingRadius(mesh);
        m_source.reset();
        m_surface.reset();
    }
    // To grow what was undone in the middle of it would take the place of the stroke before.
    if (m_movement && (change.mesh || !isLaid())) finish();
    if (change.mesh || change.layers) emit changed();
}

const TextureLayer* Painting::layer() const {
    return m_selection.selectedLayer();
}

std::vector<BrushKind> Painting::kinds() const {
    if (!layer()) return {};
    if (layer()->photo) return {BrushKind::Erase, BrushKind::Restore};
    return {BrushKind::Colour, BrushKind::Clone, BrushKind::Heal, BrushKind::Erase, BrushKind::Restore};
}

Painting::Brush Painting::brush() const {
    Brush brush = m_brush;
    if (layer() && !layer()->photo) brush.kind = m_paintKind;
    return brush;
}

void Painting::setBrush(const Brush& brush) {
    const bool paints = layer() && !layer()->photo;
    if (paints) m_paintKind = brush.kind;
    const BrushKind ofPhotos = paints ? m_brush.kind : brush.kind;
    m_brush = brush;
    m_brush.kind = ofPhotos;
    m_brush.radius = std::min(brush.radius, largestRadius());
    emit changed();
}

double Painting::largestRadius() const {
    const TriangleMesh& mesh = *m_document.project().mesh;
    if (mesh.vertices.empty()) return texture_limits::longestPhoto;
    return std::clamp(boundingBox(mesh.vertices).diagonal().norm() / 2, texture_limits::shortestPhoto,
                      texture_limits::longestPhoto);
}

void Painting::setSource(const BrushPoint& point) {
    m_source = point.place;
    emit changed();
}

QString Painting::refusal() const {
    if (!layer()) return tr("No layer is selected that could be painted on");
    if (copies(brush().kind) && !m_source)
        return tr("Ctrl and a click say first where the brush takes its colours");
    std::size_t points = 0;
    for (const auto& stroke : layer()->strokes)
        points += stroke->path.size();
    if (layer()->strokes.size() >= texture_limits::mostStrokes ||
        points >= texture_limits::mostBrushPoints / 2)
        return tr("This layer holds as many strokes as it can: add another paint layer");
    return {};
}

QString Painting::warning(const BrushPoint& point) {
    if (!layer()->visible) return tr("Nothing of it is seen: the layer is hidden");
    if (layer()->opacity <= 0) return tr("Nothing of it is seen: the layer's opacity is 0 %");
    const auto& layers = m_document.project().layers;
    if (layers.back().id == layer()->id) return {}; // nothing lies above
    const SurfacePoint place{point.place, point.normal.normalized()};
    const TextureLayer* above = coveringLayer(layers, layer()->id, place, surface());
    return above ? tr("Nothing of it is seen here: %1 covers it").arg(QString::fromStdString(above->name))
                 : QString();
}

const SurfaceQuery& Painting::surface() {
    const TriangleMesh& mesh = *m_document.project().mesh;
    if (!m_surface) m_surface.emplace(mesh.vertices, mesh.triangles);
    return *m_surface;
}

void Painting::setPressureUse(const PressureUse& use) {
    m_pressureUse = use;
    emit changed();
}

BrushShares Painting::sharesAt(std::optional<double> pressure) const {
    const double share = std::clamp(pressure.value_or(1), 0.0, 1.0);
    return {m_pressureUse.size ? std::max(leastSize, share) : 1, m_pressureUse.strength ? share : 1};
}

void Painting::begin(const BrushTouch& touch) {
    const QString why = refusal();
    if (!why.isEmpty()) return emit message(why);
    const QString unseen = warning(touch.point);
    if (!unseen.isEmpty()) emit message(unseen);
    ++m_gesture;
    BrushStroke stroke = brush();
    if (copies(stroke.kind)) stroke.shift = *m_source - touch.point.place;
    const bool isPressed = touch.pressure && (m_pressureUse.size || m_pressureUse.strength);
    m_movement = Movement{*m_selection.photo(), {stroke}, {}, false, isPressed};
    append(touch);
    edit();
}

void Painting::goOn(const std::vector<std::optional<BrushTouch>>& touches) {
    if (!m_movement) return;
    bool grows = false;
    for (const auto& touch : touches)
        grows = extend(touch) || grows;
    if (grows) edit();
}

void Painting::append(const BrushTouch& touch) {
    BrushStroke& stroke = m_movement->strokes.back();
    stroke.path.push_back(touch.point);
    if (m_movement->isPressed) stroke.shares.push_back(sharesAt(touch.pressure));
}

/// False when nothing is added.
bool Painting::extend(const std::optional<BrushTouch>& touch) {
    if (!touch) m_movement->isOff = true;
    if (!touch || isFull()) return false;
    std::vector<BrushStroke>& strokes = m_movement->strokes;
    if (std::exchange(m_movement->isOff, false)) {
        strokes.push_back(strokes.back());
        strokes.back().path.clear();
        strokes.back().shares.clear();
    } else if (isClose(touch->point, strokes.back()))
        return m_movement->isPressed && pressHarder(strokes.back().shares.back(), sharesAt(touch->pressure));
    append(*touch);
    return true;
}

/// Whether the layer takes no more of this movement.
bool Painting::isFull() const {
    const auto& [layer, strokes, laid, isOff, isPressed] = *m_movement;
    std::size_t points = 0;
    for (const BrushStroke& stroke : strokes)
        points += stroke.path.size();
    const std::size_t before = partOf(m_document.project().layers, layer).strokes.size() - laid.size();
    return points >= texture_limits::mostBrushPoints / 2 ||
           (isOff && before + strokes.size() >= texture_limits::mostStrokes);
}

void Painting::finish() {
    if (m_movement) m_document.finishGesture();
    m_movement.reset();
}

/// Other edits may have come since the movement began, as of a photo that is prepared now: they stay.
void Painting::drop() {
    if (!m_movement) return;
    const Movement dropped = *m_movement;
    const bool isAlone = isLastStep();
    m_movement.reset();
    // The step of the stroke itself then changes nothing and goes: it cannot be redone.
    const MergeKey key = isAlone ? keyOf(dropped.layer) : MergeKey();
    m_document.edit(
        tr("Drop the stroke"),
        [&](Project& project) {
            BrushStrokes& strokes = partOf(project.layers, dropped.layer).strokes;
            strokes.resize(strokes.size() - dropped.laid.size());
        },
        key);
    m_document.finishGesture();
}

MergeKey Painting::keyOf(LayerId layer) const {
    return {EditKind::BrushStroke, layer, static_cast<std::uint64_t>(m_gesture)};
}

/// Whether the movement's last stroke is the topmost of its layer. Two may be equal: it is this one.
bool Painting::isLaid() const {
    const TextureLayer* painted = findPart(m_document.project().layers, m_movement->layer);
    return painted && !painted->strokes.empty() &&
           painted->strokes.back().get() == m_movement->laid.back().get();
}

/// Whether the last step is to paint this movement, all of it.
bool Painting::isLastStep() const {
    const QUndoStack& steps = *m_document.undoStack();
    if (steps.index() == 0) return false;
    const auto& last = static_cast<const ProjectCommand&>(*steps.command(steps.index() - 1));
    const TextureLayer* before = findPart(last.before()->layers, m_movement->layer);
    const std::size_t strokes = partOf(m_document.project().layers, m_movement->layer).strokes.size();
    return before && before->strokes.size() + m_movement->laid.size() == strokes;
}

/// The last stroke that was laid has grown, those before it stay, those after it are new.
void Painting::edit() {
    auto& [layer, strokes, laid, isOff, isPressed] = *m_movement;
    const std::size_t before = laid.size();
    if (!laid.empty()) laid.pop_back();
    while (laid.size() < strokes.size())
        laid.push_back(std::make_shared<const BrushStroke>(strokes[laid.size()]));
    // Who hears of the edit may end the movement.
    const Movement now = *m_movement;
    m_document.edit(
        stepName(now.strokes.front().kind),
        [&](Project& project) {
            BrushStrokes& held = partOf(project.layers, now.layer).strokes;
            held.resize(held.size() - before);
            held.insert(held.end(), now.laid.begin(), now.laid.end());
        },
        keyOf(now.layer));
}

} // namespace esm
