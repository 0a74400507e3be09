#include "app/editor/commands/project_command.h"

#include "app/editor/document/document.h"

namespace esm {

ProjectCommand::ProjectCommand(Document& document, Project after, const QString& text, QString mergeKey)
    : QUndoCommand(text), m_document(document), m_before(document.project()), m_after(std::move(after)),
      m_mergeKey(std::move(mergeKey)) {}

void ProjectCommand::undo() {
    m_document.take(m_before);
}

void ProjectCommand::redo() {
    m_document.take(m_after);
}

bool ProjectCommand::mergeWith(const QUndoCommand* next) {
    // Every command on this stack is a ProjectCommand with the same id.
    const auto& later = static_cast<const ProjectCommand&>(*next);
    if (later.m_mergeKey != m_mergeKey) return false;
    m_after = later.m_after;
    setObsolete(!difference(m_before, m_after).any());
    return true;
}

} // namespace esm
