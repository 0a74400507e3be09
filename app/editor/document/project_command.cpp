#include "app/editor/document/project_command.h"

#include "app/editor/document/document.h"

namespace esm {

ProjectCommand::ProjectCommand(Document& document, Project after, EditKind kind)
    : QUndoCommand(kind.text), m_document(document), m_before(document.project()), m_after(std::move(after)),
      m_kind(std::move(kind)) {}

void ProjectCommand::undo() {
    m_document.take(m_before, m_kind.systemOf);
}

void ProjectCommand::redo() {
    m_document.take(m_after, m_kind.systemOf);
}

bool ProjectCommand::mergeWith(const QUndoCommand* next) {
    // Every command on this stack is a ProjectCommand with the same id.
    const auto& later = static_cast<const ProjectCommand&>(*next);
    if (later.m_kind.mergeKey != m_kind.mergeKey) return false;
    m_after = later.m_after;
    setObsolete(m_before == m_after);
    return true;
}

} // namespace esm
