#pragma once

#include "app/editor/document/edit_kind.h"

#include <QUndoCommand>

#include <memory>
#include <optional>

namespace esm {

class Document;

/// What an edit is called, and how it is told apart from others.
struct EditStep {
    QString text;
    MergeKey mergeKey;
    int gesture;                      ///< that it is part of
    std::optional<RegionId> systemOf; ///< the region whose fuzzy system is edited
};

/// One edit: the project before and the project after, a few pointers each. Merges with the one before it
/// when both carry the same key in the same gesture, and drops itself when nothing is left of the change.
class ProjectCommand : public QUndoCommand {
public:
    using Value = std::shared_ptr<const Project>;

    ProjectCommand(Document& document, Value before, Value after, EditStep step);

    void undo() override;
    void redo() override;
    int id() const override { return m_step.mergeKey.kind == EditKind::Alone ? -1 : 1; }
    bool mergeWith(const QUndoCommand* next) override;

    const Value& before() const { return m_before; }
    const Value& after() const { return m_after; }
    const EditStep& step() const { return m_step; }

private:
    Document& m_document;
    Value m_before, m_after;
    EditStep m_step;
    bool m_wasDone = false;
};

} // namespace esm
