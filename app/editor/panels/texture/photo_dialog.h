#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "app/editor/edits/preparation_session.h"
#include "app/editor/panels/texture/adjust_page.h"
#include "app/editor/panels/texture/field_page.h"
#include "app/editor/panels/texture/highlight_page.h"
#include "app/editor/panels/texture/lens_page.h"
#include "app/editor/panels/texture/mask_pages.h"
#include "app/editor/panels/texture/white_page.h"
#include "widgets/inputs/number_field.h"
#include "widgets/texture/photo_canvas.h"

#include <QButtonGroup>
#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

namespace esm {

/// What is done to a photo in its own window.
enum class PhotoTask { Field, Erase, Restore, Outline, Box, Region, Highlights, White, Adjust, Lens, Crop };

/// The selected photo in a window of its own: its field is set, what is no tissue masked, highlights and
/// white chosen, colours adjusted, lines drawn along what should be straight, and a frame cut out. Every
/// change is an edit of the document at once; all of them can be put back while the window is open.
class PhotoDialog : public QDialog {
    Q_OBJECT

public:
    PhotoDialog(Document& document, PreparationEdits& edits, QWidget* parent = nullptr);

    /// Esc and the window's own button ask where anything was done.
    void reject() override;

private:
    void addPages();
    void connectCanvas();
    QHBoxLayout* taskRow();
    QWidget* cropPage();
    QHBoxLayout* closeRow();
    QPushButton* addRowButton(QHBoxLayout* row, const QString& text);
    QAction* addStepAction(QHBoxLayout* row, const QString& text, const QKeySequence& key);
    void keep();
    void putBack();
    void showSteps();
    void choose(PhotoTask task);
    void showPhoto();
    bool isStraightened(const TextureLayer& layer) const;
    void showPicture(const TextureLayer& layer);
    void showHint(const QString& problem = {});
    void setCrop(const std::optional<PhotoCrop>& crop);
    void editCropField(int PhotoCrop::*part, double value);

    PreparationEdits& m_edits;
    PreparationSession m_session;
    QAction *m_undo = nullptr, *m_redo = nullptr;
    PhotoCanvas* m_canvas;
    QStackedWidget* m_pages;
    QButtonGroup* m_tasks;
    FieldPage* m_fieldPage;
    BrushPage* m_brushPage;
    OutlinePage* m_outlinePage;
    RegionPage* m_regionPage;
    HighlightPage* m_highlightPage;
    WhitePage* m_whitePage;
    AdjustPage* m_adjustPage;
    LensPage* m_lensPage;
    QPushButton* m_whole;
    std::vector<std::pair<int PhotoCrop::*, NumberField*>> m_cropFields;
    QWidget* m_cropPage;
    QLabel* m_hint;
    PhotoTask m_task = PhotoTask::Erase;
    std::shared_ptr<const Photo> m_photo;    ///< that is shown
    std::shared_ptr<const Image> m_prepared; ///< that is shown; null for the photo itself
};

} // namespace esm
