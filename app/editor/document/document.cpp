#include "app/editor/document/document.h"

#include "app/editor/document/project_command.h"

namespace esm {

Document::Document(Project project, QObject* parent) : QObject(parent), m_project(std::move(project)) {
    numberParts();
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

void Document::edit(const QString& text, const std::function<void(Project&)>& change,
                    const MergeKey& mergeKey, std::optional<RegionId> systemOf) {
    Project after = m_project;
    change(after);
    if (after == m_project) return;
    m_undoStack.push(new ProjectCommand(*this, std::move(after), {text, mergeKey, m_gesture, systemOf}));
}

void Document::replace(Project project, std::optional<std::filesystem::path> path, Origin origin,
                       Former former) {
    m_path = std::move(path);
    m_former = std::move(former);
    m_project = std::move(project);
    numberParts();
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

void Document::numberParts() {
    esm::numberParts(m_project);
    m_lastRegion = static_cast<std::uint32_t>(m_project.regions.size());
    m_lastLayer = static_cast<std::uint32_t>(m_project.layers.size());
}

void Document::take(const Project& project, std::optional<RegionId> systemOf) {
    Change change = difference(m_project, project);
    if (systemOf)
        change.system = {partOf(m_project.regions, *systemOf).system,
                         partOf(project.regions, *systemOf).system};
    m_project = project;
    emit changed(change);
}

} // namespace esm
