#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "widgets/view/photo_view.h"

#include <QComboBox>
#include <QDialog>

namespace esm {

/// A picture kept in sight beside the organ, whatever tool is in hand: the selected photo, another one of the
/// project, or a file that need not be part of it.
class ReferenceWindow : public QDialog {
    Q_OBJECT

public:
    ReferenceWindow(Document& document, Selection& selection, QWidget* parent = nullptr);
    ~ReferenceWindow() override;

    /// Shows a picture that is no photo of the project.
    void showFile(const std::filesystem::path& file);

private:
    /// A picture from a file, with its name.
    struct Opened {
        QString name;
        std::shared_ptr<const Image> picture;
    };

    void layOut();
    void chooseAFile();
    void fillChoice();
    void showChosen();
    std::shared_ptr<const Image> chosen() const;

    Document& m_document;
    Selection& m_selection;
    QComboBox* m_choice;
    PhotoView* m_view;
    std::vector<Opened> m_opened;
};

} // namespace esm
