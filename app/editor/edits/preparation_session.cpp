#include "app/editor/edits/preparation_session.h"

#include <algorithm>

namespace esm {

namespace {

void takePreparations(Project& project, const Project& from) {
    for (TextureLayer& layer : project.layers) {
        const TextureLayer* other = findPart(from.layers, layer.id);
        if (!other || other->photo != layer.photo) continue;
        layer.preparation = other->preparation;
        layer.prepared = other->prepared;
    }
}

/// Whether nothing but the preparation of photos tells the two apart.
bool differInPreparations(const Project& before, const Project& after) {
    Project same = before;
    takePreparations(same, after);
    return same == after;
}

const Project& beforeStep(const DocumentState& state, std::size_t step) {
    return step == 0 ? *state.base : *state.steps[step - 1].after;
}

bool isOfPreparation(const DocumentState& state, std::size_t step) {
    return differInPreparations(beforeStep(state, step), *state.steps[step].after);
}

} // namespace

PreparationSession::PreparationSession(Document& document, PreparationEdits& edits, QObject* parent)
    : QObject(parent), m_document(document), m_edits(edits), m_before(document.project()) {
    document.finishGesture(); // or the first edit might become part of the step before it
    edits.finishGesture();
    const DocumentState state = document.state();
    if (state.index > 0) m_lastBefore = state.steps[static_cast<std::size_t>(state.index) - 1].after;
    if (state.index < static_cast<int>(state.steps.size())) m_redoBefore = state.steps.back().after;
    connect(&document, &Document::stepped, this, &PreparationSession::follow);
    connect(&edits, &PreparationEdits::changed, this, &PreparationSession::changed);
}

/// Where the steps begin that were made since; the oldest ones may have left the list meanwhile.
std::size_t PreparationSession::firstStep(const DocumentState& state) const {
    const auto last = std::find_if(state.steps.begin(), state.steps.end(),
                                   [&](const DocumentStep& step) { return step.after == m_lastBefore; });
    return last == state.steps.end() ? 0 : static_cast<std::size_t>(last - state.steps.begin()) + 1;
}

/// Who undoes further than to where this began, elsewhere in the window, moves that place.
void PreparationSession::follow() {
    const DocumentState state = m_document.state();
    const auto done = static_cast<std::size_t>(state.index);
    if (done < firstStep(state)) {
        m_lastBefore = done > 0 ? state.steps[done - 1].after : nullptr;
        m_redoBefore = state.steps.back().after;
    }
    emit changed();
}

bool PreparationSession::isPreparedAsBefore() const {
    Project same = m_document.project();
    takePreparations(same, m_before);
    return same == m_document.project();
}

bool PreparationSession::isChanged() const {
    return m_edits.isEditing() || !isPreparedAsBefore();
}

bool PreparationSession::canUndo() const {
    if (m_edits.isEditing()) return true;
    const DocumentState state = m_document.state();
    const auto done = static_cast<std::size_t>(state.index);
    return done > firstStep(state) && isOfPreparation(state, done - 1);
}

bool PreparationSession::canRedo() const {
    const DocumentState state = m_document.state();
    const auto done = static_cast<std::size_t>(state.index);
    return done < state.steps.size() && state.steps.back().after != m_redoBefore &&
           isOfPreparation(state, done);
}

void PreparationSession::undo() {
    if (!canUndo() || m_edits.dropLatest()) return;
    m_document.undoStack()->undo();
}

void PreparationSession::redo() {
    if (canRedo()) m_document.undoStack()->redo();
}

void PreparationSession::putBack() {
    while (m_edits.dropLatest()) {
    }
    const DocumentState state = m_document.state();
    const std::size_t first = firstStep(state);
    std::size_t own = static_cast<std::size_t>(state.index);
    while (own > first && isOfPreparation(state, own - 1))
        --own;
    if (own == first) m_document.goTo(static_cast<int>(first));
    m_document.finishGesture();
    m_document.edit(tr("Put photo back"), [&](Project& project) { takePreparations(project, m_before); });
}

} // namespace esm
