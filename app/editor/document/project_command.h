#pragma once

#include "core/project/project.h"

#include <QUndoCommand>

#include <optional>

namespace esm {

class Document;

/// What an edit is called, and how it is told apart from others.
struct EditKind {
    QString text;
    QString mergeKey;
    std::optional<std::size_t> systemOf; ///< the region whose fuzzy system is edited
};

/// One edit: the project before and the project after, a few pointers each. Merges with the one before it
/// when both carry the same key, and drops itself when nothing is left of the change.
class ProjectCommand : public QUndoCommand {
public:
    ProjectCommand(Document& document, Project after, EditKind kind);

    void undo() override;
    void redo() override;
    int id() const override { return m_kind.mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* next) override;

private:
    Document& m_document;
    Project m_before, m_after;
    EditKind m_kind;
};

} // namespace esm
