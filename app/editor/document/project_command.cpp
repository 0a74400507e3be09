#include "app/editor/document/project_command.h"

#include "app/editor/document/document.h"

#include <utility>

namespace esm {

ProjectCommand::ProjectCommand(Document& document, Value before, Value after, EditStep step)
    : QUndoCommand(step.text), m_document(document), m_before(std::move(before)), m_after(std::move(after)),
      m_step(std::move(step)) {}

void ProjectCommand::undo() {
    m_document.take(*m_before, {m_step.systemOf, true});
}

void ProjectCommand::redo() {
    // The stack does at once what is pushed.
    m_document.take(*m_after, {m_step.systemOf, std::exchange(m_wasDone, true)});
}

bool ProjectCommand::mergeWith(const QUndoCommand* next) {
    // Every command on this stack is a ProjectCommand with the same id.
    const auto& later = static_cast<const ProjectCommand&>(*next);
    if (later.m_step.mergeKey != m_step.mergeKey || later.m_step.gesture != m_step.gesture) return false;
    m_after = later.m_after;
    setObsolete(*m_before == *m_after);
    return true;
}

} // namespace esm
