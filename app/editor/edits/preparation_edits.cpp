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
    const auto selected = m_selection.photo();
    if (!selected || *selected >= m_document.project().layers.size()) return nullptr;
    const TextureLayer& layer = m_document.project().layers[*selected];
    return layer.photo ? &layer : nullptr;
}

void PreparationEdits::edit(const QString& text, const WishChange& change, const QString& mergeKey) {
    const TextureLayer* selected = layer();
    if (!selected) return;
    Edit asked{*m_selection.photo(), selected->photo, text, mergeKey, change, m_gesture};
    const bool replaces = !mergeKey.isEmpty() && !m_waiting.empty() &&
                          m_waiting.back().mergeKey == mergeKey && m_waiting.back().gesture == m_gesture &&
                          m_waiting.back().layer == asked.layer;
    if (replaces)
        m_waiting.back() = std::move(asked);
    else
        m_waiting.push_back(std::move(asked));
    begin();
    emit changed();
}

PreparationWish PreparationEdits::wanted() const {
    const TextureLayer* selected = layer();
    if (!selected) return {};
    PreparationWish wish{selected->preparation, {}};
    const auto applies = [&](const Edit& edit) { return placeOf(edit) == m_selection.photo(); };
    if (m_running && m_running->edit && applies(*m_running->edit)) m_running->edit->change(wish);
    for (const Edit& edit : m_waiting)
        if (applies(edit)) edit.change(wish);
    return wish;
}

const PreparedPhoto* PreparationEdits::shown() const {
    const TextureLayer* selected = layer();
    return selected && m_shown.photo == selected->photo ? &m_shown : nullptr;
}

/// Where the edit's layer lies by now.
std::optional<std::size_t> PreparationEdits::placeOf(const Edit& edit) const {
    const auto& layers = m_document.project().layers;
    if (edit.layer < layers.size() && layers[edit.layer].photo == edit.photo) return edit.layer;
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (layers[i].photo == edit.photo) return i;
    return std::nullopt;
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
    const auto place = placeOf(edit);
    if (!place) return false;
    const TextureLayer& layer = m_document.project().layers[*place];
    PreparationWish wish{layer.preparation, {}};
    edit.change(wish);
    if (wish.preparation == layer.preparation && !wish.find.any()) return false;
    PreparationRequest request{layer.photo, wish.preparation, wish.find, std::nullopt, nullptr};
    if (wish.find.match) request.laid = LaidLayer{m_document.project(), *place};
    const int number = m_preparer.prepare(std::move(request));
    m_running = Running{edit, wish, layer.preparation, number};
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

void PreparationEdits::finish(const Running& done, const PreparedPhoto& result) {
    if (!result.failure.isEmpty()) {
        if (done.edit)
            emit failed(done.edit->text, result.failure);
        else if (const TextureLayer* selected = layer()) // not to be tried again
            m_shown = {result.number, selected->photo, done.before, selected->prepared, 0, {}, {}, {}};
        return;
    }
    if (!done.edit) {
        m_shown = result;
        return;
    }
    const auto place = placeOf(*done.edit);
    if (!place) return;
    if (m_document.project().layers[*place].preparation != done.before) {
        m_waiting.push_front(*done.edit); // undone meanwhile, say
        return;
    }
    if (place == m_selection.photo()) {
        m_shown = result;
        const SoughtSteps& sought = done.wish.find;
        if (sought.field || result.preparation.field) m_missing.field = !result.preparation.field;
        if (sought.whiteBalance || result.preparation.whiteBalance)
            m_missing.whiteBalance = !result.preparation.whiteBalance;
        if (sought.match || result.preparation.match) m_missing.match = !result.preparation.match;
    }
    if (done.edit->gesture != m_doneGesture) m_document.finishGesture();
    m_doneGesture = done.edit->gesture;
    const QString key = done.edit->mergeKey;
    m_document.edit(
        done.edit->text,
        [&](Project& project) {
            project.layers[*place].preparation = result.preparation;
            project.layers[*place].prepared = result.picture;
        },
        key.isEmpty() ? QString() : QStringLiteral("%1 %2").arg(key).arg(*place));
}

} // namespace esm
