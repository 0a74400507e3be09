#pragma once

#include "core/model/project.h"

#include <QUndoCommand>

namespace esm {

class Document;

/// One edit: the project before and the project after, a few pointers each. Merges with the one before it
/// when both carry the same key, and drops itself when nothing is left of the change.
class ProjectCommand : public QUndoCommand {
public:
    ProjectCommand(Document& document, Project after, const QString& text, QString mergeKey);

    void undo() override;
    void redo() override;
    int id() const override { return m_mergeKey.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* next) override;

private:
    Document& m_document;
    Project m_before, m_after;
    QString m_mergeKey;
};

} // namespace esm
