#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/workers/photo_preparer.h"

#include <deque>

namespace esm {

/// What a preparation is to become: its numbers, and steps that are to be found in the photo.
struct PreparationWish {
    PhotoPreparation preparation;
    SoughtSteps find;
};

/// Edits of how the selected photo is prepared. The picture is computed beside the window, and the document
/// is edited once it is there: one undoable step, in the order in which they were asked for. Of edits of
/// one kind that follow each other, those that wait give way to the latest.
class PreparationEdits : public QObject {
    Q_OBJECT

public:
    using WishChange = std::function<void(PreparationWish&)>;

    PreparationEdits(Document& document, Selection& selection);

    /// @param change may be made more than once, so it sets what it is about instead of going on from it,
    /// unless it is of the kind `Alone`
    void edit(const QString& text, const WishChange& change, EditKind kind = EditKind::Alone);
    /// The drag or run of keys in progress is over: the next edit starts a step of its own.
    void finishGesture() { ++m_gesture; }

    const TextureLayer* layer() const; ///< that is selected and has a photo; null without one
    /// What the selected photo's preparation will be once all that waits is done.
    PreparationWish wanted() const;
    /// What is known of the selected photo; null while nothing is.
    const PreparedPhoto* shown() const;
    /// Steps that were looked for in vain for the selected photo.
    SoughtSteps missing() const { return m_missing; }
    /// Why the last edit of the selected photo could not be made; empty when all is well.
    QString failure() const;
    bool isWorking() const { return m_running || !m_waiting.empty(); }
    /// Whether an edit waits for its picture.
    bool isEditing() const { return !m_waiting.empty() || (m_running && m_running->edit); }
    /// The latest edit that waits for its picture is not made. False where none waits.
    bool dropLatest();

signals:
    void changed();

private:
    struct Edit {
        LayerId layer;
        QString text;
        EditKind kind;
        WishChange change;
        int gesture;
    };
    struct Running {
        std::optional<Edit> edit; ///< none where only what is known is looked at
        PreparationWish wish;
        PhotoPreparation before;
        int number;
    };
    /// An edit that could not be made.
    struct Failure {
        LayerId layer;
        std::shared_ptr<const Photo> photo;
        PhotoPreparation preparation; ///< that the layer has kept; with another one it is over
        QString reason;
    };

    void follow();
    void begin();
    bool beginEdit(const Edit& edit);
    void look();
    void take();
    void finish(const Running& done, const PreparedPhoto& result);
    void fail(const Running& done, const PreparedPhoto& result);

    Document& m_document;
    Selection& m_selection;
    PhotoPreparer m_preparer;
    std::deque<Edit> m_waiting;
    std::optional<Running> m_running;
    PreparedPhoto m_shown;
    SoughtSteps m_missing;
    std::optional<Failure> m_failure;
    int m_gesture = 0, m_doneGesture = 0;
};

} // namespace esm
