#include "app/editor/document/document.h"

#include "app/editor/document/project_command.h"

namespace esm {

Document::Document(Project project, QObject* parent) : QObject(parent), m_project(std::move(project)) {
    m_undoStack.setUndoLimit(500);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

Document::~Document() {
    // The stack empties itself when it goes, which is news to nobody: the listeners may be half gone as well.
    m_undoStack.disconnect();
}

QString Document::title() const {
    if (m_path) return QString::fromStdString(m_path->filename().string());
    return m_former.title.isEmpty() ? QString::fromStdString(m_project.name) : m_former.title;
}

void Document::edit(const QString& text, const std::function<void(Project&)>& change, const QString& mergeKey,
                    std::optional<std::size_t> systemOf) {
    Project after = m_project;
    change(after);
    if (after == m_project) return;
    const QString key = mergeKey.isEmpty() ? QString() : QStringLiteral("%1 %2").arg(m_gesture).arg(mergeKey);
    m_undoStack.push(new ProjectCommand(*this, std::move(after), {text, key, systemOf}));
}

void Document::replace(Project project, std::optional<std::filesystem::path> path, Origin origin,
                       Former former) {
    m_path = std::move(path);
    m_former = std::move(former);
    m_project = std::move(project);
    m_unfinished.clear();
    m_undoStack.clear();
    if (origin == Origin::Unsaved) m_undoStack.resetClean();
    emit changed(Change::everything());
    emit titleChanged();
}

void Document::markSaved(const std::filesystem::path& path, const Project& written) {
    m_path = path;
    if (written != m_project)
        m_undoStack.resetClean();
    else
        m_undoStack.setClean();
    finishGesture();
    emit titleChanged();
}

void Document::take(const Project& project, std::optional<std::size_t> systemOf) {
    Change change = difference(m_project, project);
    if (systemOf) change.system = {m_project.regions[*systemOf].system, project.regions[*systemOf].system};
    m_project = project;
    emit changed(change);
}

} // namespace esm
