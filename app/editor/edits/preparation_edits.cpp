#include "app/editor/edits/preparation_edits.h"

namespace esm {

PreparationEdits::PreparationEdits(Document& document, Selection& selection)
    : QObject(&document), m_document(document), m_selection(selection) {
    connect(&m_preparer, &PhotoPreparer::prepared, this, &PreparationEdits::take);
    connect(&selection, &Selection::changed, this, &PreparationEdits::follow);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.layers) follow();
    });
    follow();
}

const TextureLayer* PreparationEdits::layer() const {
    const TextureLayer* selected = m_selection.selectedLayer();
    return selected && selected->photo ? selected : nullptr;
}

void PreparationEdits::edit(const QString& text, const WishChange& change, EditKind kind) {
    const TextureLayer* selected = layer();
    if (!selected) return;
    if (m_failure && m_failure->layer == selected->id) m_failure.reset();
    Edit asked{selected->id, text, kind, change, m_gesture};
    const bool replaces = kind != EditKind::Alone && !m_waiting.empty() && m_waiting.back().kind == kind &&
                          m_waiting.back().gesture == m_gesture && m_waiting.back().layer == asked.layer;
    if (replaces)
        m_waiting.back() = std::move(asked);
    else
        m_waiting.push_back(std::move(asked));
    begin();
    emit changed();
}

bool PreparationEdits::dropLatest() {
    if (!isEditing()) return false;
    if (m_waiting.empty())
        m_running.reset(); // what is computed comes to nothing
    else
        m_waiting.pop_back();
    begin();
    emit changed();
    return true;
}

PreparationWish PreparationEdits::wanted() const {
    const TextureLayer* selected = layer();
    if (!selected) return {};
    PreparationWish wish{selected->preparation, {}};
    const auto applies = [&](const Edit& edit) { return edit.layer == selected->id; };
    if (m_running && m_running->edit && applies(*m_running->edit)) m_running->edit->change(wish);
    for (const Edit& edit : m_waiting)
        if (applies(edit)) edit.change(wish);
    return wish;
}

const PreparedPhoto* PreparationEdits::shown() const {
    const TextureLayer* selected = layer();
    return selected && m_shown.photo == selected->photo ? &m_shown : nullptr;
}

QString PreparationEdits::failure() const {
    const TextureLayer* selected = layer();
    const bool isOfSelected = selected && m_failure && m_failure->layer == selected->id &&
                              m_failure->photo == selected->photo &&
                              m_failure->preparation == selected->preparation;
    return isOfSelected ? m_failure->reason : QString();
}

void PreparationEdits::follow() {
    const TextureLayer* selected = layer();
    if (!selected || m_shown.photo != selected->photo) m_missing = {};
    begin();
    emit changed();
}

/// Takes up what waits, one at a time; with nothing to do, looks at what is selected.
void PreparationEdits::begin() {
    while ((!m_running || !m_running->edit) && !m_waiting.empty()) {
        const Edit edit = m_waiting.front();
        m_waiting.pop_front();
        if (beginEdit(edit)) return;
    }
    if (!m_running || !m_running->edit) look();
}

bool PreparationEdits::beginEdit(const Edit& edit) {
    const TextureLayer* layer = findPart(m_document.project().layers, edit.layer);
    if (!layer) return false;
    PreparationWish wish{layer->preparation, {}};
    edit.change(wish);
    if (wish.preparation == layer->preparation && !wish.find.any()) return false;
    PreparationRequest request{layer->photo, wish.preparation, wish.find, std::nullopt, nullptr};
    if (wish.find.match) request.laid = LaidLayer{m_document.project(), edit.layer};
    const int number = m_preparer.prepare(std::move(request));
    m_running = Running{edit, wish, layer->preparation, number};
    return true;
}

void PreparationEdits::look() {
    const TextureLayer* selected = layer();
    if (!selected || (m_shown.photo == selected->photo && m_shown.picture.get() == selected->prepared.get()))
        return;
    const int number =
        m_preparer.prepare({selected->photo, selected->preparation, {}, std::nullopt, selected->prepared});
    m_running = Running{std::nullopt, {selected->preparation, {}}, selected->preparation, number};
}

void PreparationEdits::take() {
    const PreparedPhoto result = m_preparer.result();
    if (!m_running || result.number != m_running->number) return;
    const Running done = *m_running;
    m_running.reset();
    finish(done, result);
    begin();
    emit changed();
}

void PreparationEdits::fail(const Running& done, const PreparedPhoto& result) {
    if (done.edit) {
        const TextureLayer* edited = findPart(m_document.project().layers, done.edit->layer);
        if (edited) m_failure = Failure{edited->id, edited->photo, done.before, result.failure};
    } else if (const TextureLayer* selected = layer()) // not to be tried again
        m_shown = {result.number, selected->photo, done.before, selected->prepared, 0, {}, {}, {}};
}

void PreparationEdits::finish(const Running& done, const PreparedPhoto& result) {
    if (!result.failure.isEmpty()) return fail(done, result);
    if (!done.edit) {
        m_shown = result;
        return;
    }
    const TextureLayer* edited = findPart(m_document.project().layers, done.edit->layer);
    if (!edited) return;
    if (edited->preparation != done.before) {
        m_waiting.push_front(*done.edit); // undone meanwhile, say
        return;
    }
    if (m_selection.photo() == edited->id) {
        m_shown = result;
        const SoughtSteps& sought = done.wish.find;
        if (sought.field || result.preparation.field) m_missing.field = !result.preparation.field;
        if (sought.soughtWhite() || result.preparation.whiteBalance)
            m_missing.whiteBalance = !result.preparation.whiteBalance;
        if (sought.match || result.preparation.match) m_missing.match = !result.preparation.match;
    }
    if (done.edit->gesture != m_doneGesture) m_document.finishGesture();
    m_doneGesture = done.edit->gesture;
    m_document.edit(done.edit->text,
                    [&](Project& project) {
                        TextureLayer& layer = partOf(project.layers, done.edit->layer);
                        layer.preparation = result.preparation;
                        layer.prepared = result.picture;
                    },
                    {done.edit->kind, done.edit->layer});
}

} // namespace esm
