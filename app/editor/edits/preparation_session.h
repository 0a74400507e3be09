#pragma once

#include "app/editor/edits/preparation_edits.h"

namespace esm {

/// What has been done to the preparation of photos since this began: it alone is undone, redone and put back.
class PreparationSession : public QObject {
    Q_OBJECT

public:
    PreparationSession(Document& document, PreparationEdits& edits, QObject* parent = nullptr);

    /// Whether any photo is prepared differently by now, or is about to be.
    bool isChanged() const;
    bool canUndo() const;
    bool canRedo() const;
    /// Of edits that still wait for their picture the latest is dropped first.
    void undo();
    void redo();
    /// Photos are prepared again as they were when this began. Where nothing else was done meanwhile, the
    /// steps are undone, and can be redone; else it is a step of its own.
    void putBack();

signals:
    void changed();

private:
    using Value = std::shared_ptr<const Project>;

    std::size_t firstStep(const DocumentState& state) const;
    void follow();
    bool isPreparedAsBefore() const;

    Document& m_document;
    PreparationEdits& m_edits;
    Project m_before;
    Value m_lastBefore; ///< after the last step that was done when this began; null where none was
    Value m_redoBefore; ///< after the last step that could be redone then; null where none could
};

} // namespace esm
