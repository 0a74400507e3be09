#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "app/editor/panels/texture/lens_page.h"
#include "widgets/inputs/number_field.h"
#include "widgets/texture/photo_canvas.h"

#include <QButtonGroup>
#include <QDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

namespace esm {

/// The selected photo in a window of its own: text and overlays are brushed out, lines drawn along what
/// should be straight, and a frame cut out. Every change is an edit of the document at once.
class PhotoDialog : public QDialog {
    Q_OBJECT

public:
    PhotoDialog(Document& document, PreparationEdits& edits, QWidget* parent = nullptr);

private:
    QHBoxLayout* toolRow();
    QWidget* brushPage();
    QWidget* cropPage();
    QHBoxLayout* closeRow(Document& document);
    void chooseTool(PhotoTool tool);
    void changeBrush(double factor);
    void showPhoto();
    void showPicture(const TextureLayer& layer);
    void showHint(const QString& problem = {});
    void setCrop(const std::optional<PhotoCrop>& crop);
    void editCropField(int PhotoCrop::*part, double value);

    PreparationEdits& m_edits;
    PhotoCanvas* m_canvas;
    QStackedWidget* m_pages;
    QButtonGroup* m_tools;
    NumberField *m_radius, *m_softness;
    LensPage* m_lensPage;
    QPushButton* m_whole;
    QLabel* m_hint;
    std::vector<std::pair<int PhotoCrop::*, NumberField*>> m_cropFields;
    std::shared_ptr<const Photo> m_photo;    ///< that is shown
    std::shared_ptr<const Image> m_prepared; ///< that is shown for the crop; null for the photo itself
};

} // namespace esm
