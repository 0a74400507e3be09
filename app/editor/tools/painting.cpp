#include "app/editor/tools/painting.h"

#include "app/editor/document/project_command.h"
#include "core/texture/texture_limits.h"

#include <algorithm>

namespace esm {

namespace {

/// Share of the radius that points of a path keep between them: the brush joins them by straight lines.
constexpr double pointSpacing = 0.25;

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
    }
    // To grow what was undone in the middle of it would take the place of the stroke before.
    if (m_stroke && (change.mesh || !isLaid())) finish();
    if (change.mesh || change.layers) emit changed();
}

const TextureLayer* Painting::layer() const {
    return m_selection.selectedLayer();
}

std::vector<BrushKind> Painting::kinds() const {
    if (!layer()) return {};
    if (layer()->photo) return {BrushKind::Erase, BrushKind::Restore};
    return {BrushKind::Colour, BrushKind::Clone, BrushKind::Erase, BrushKind::Restore};
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
    emit changed();
}

void Painting::setSource(const BrushPoint& point) {
    m_source = point.place;
    emit changed();
}

QString Painting::refusal() const {
    if (!layer()) return tr("No layer is selected that could be painted on");
    if (brush().kind == BrushKind::Clone && !m_source)
        return tr("Ctrl and a click say first where the clone brush takes its colours");
    std::size_t points = 0;
    for (const auto& stroke : layer()->strokes)
        points += stroke->path.size();
    if (layer()->strokes.size() >= texture_limits::mostStrokes ||
        points >= texture_limits::mostBrushPoints / 2)
        return tr("This layer holds as many strokes as it can: add another paint layer");
    return {};
}

QString Painting::warning() const {
    if (!layer()->visible) return tr("Nothing of it is seen: the layer is hidden");
    if (layer()->opacity <= 0) return tr("Nothing of it is seen: the layer's opacity is 0 %");
    return {};
}

void Painting::begin(const BrushPoint& point) {
    const QString why = refusal();
    if (!why.isEmpty()) return emit message(why);
    if (!warning().isEmpty()) emit message(warning());
    ++m_gesture;
    m_layer = *m_selection.photo();
    m_stroke = brush();
    if (m_stroke->kind == BrushKind::Clone) m_stroke->shift = *m_source - point.place;
    m_stroke->path = {point};
    edit();
}

void Painting::goOn(const BrushPoint& point) {
    if (!m_stroke) return;
    const double way = (point.place - m_stroke->path.back().place).norm();
    if (way < pointSpacing * m_stroke->radius || m_stroke->path.size() >= texture_limits::mostBrushPoints / 2)
        return;
    m_stroke->path.push_back(point);
    edit();
}

void Painting::finish() {
    if (m_stroke) m_document.finishGesture();
    m_stroke.reset();
    m_laid.reset();
}

/// Other edits may have come since the stroke began, as of a photo that is prepared now: they stay.
void Painting::drop() {
    if (!m_stroke) return;
    const bool isAlone = isLastStep();
    finish();
    if (isAlone) return m_document.undoStack()->undo();
    m_document.edit(tr("Drop the stroke"),
                    [&](Project& project) { partOf(project.layers, m_layer).strokes.pop_back(); });
}

/// Whether the stroke is the topmost of its layer. Two may be equal: it is this one.
bool Painting::isLaid() const {
    const TextureLayer* painted = findPart(m_document.project().layers, m_layer);
    return painted && !painted->strokes.empty() && painted->strokes.back().get() == m_laid.get();
}

/// Whether the last step is to lay the stroke, all of it.
bool Painting::isLastStep() const {
    const QUndoStack& steps = *m_document.undoStack();
    if (steps.index() == 0) return false;
    const auto& last = static_cast<const ProjectCommand&>(*steps.command(steps.index() - 1));
    const TextureLayer* before = findPart(last.before()->layers, m_layer);
    return before && before->strokes.size() < partOf(m_document.project().layers, m_layer).strokes.size();
}

/// The first edit of a stroke adds it, the others replace it by what it has grown to.
void Painting::edit() {
    const auto stroke = std::make_shared<const BrushStroke>(*m_stroke);
    const bool isNew = stroke->path.size() == 1;
    m_laid = stroke;
    m_document.edit(stepName(stroke->kind),
                    [&](Project& project) {
                        BrushStrokes& strokes = partOf(project.layers, m_layer).strokes;
                        if (!isNew) strokes.pop_back();
                        strokes.push_back(stroke);
                    },
                    {EditKind::BrushStroke, m_layer, static_cast<std::uint64_t>(m_gesture)});
}

} // namespace esm
