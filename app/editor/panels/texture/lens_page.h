#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "widgets/texture/photo_canvas.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

namespace esm {

/// What stands above a photo while its lens is corrected: by lines that are drawn on it, or by a lens that
/// is known from a file.
class LensPage : public QWidget {
    Q_OBJECT

public:
    LensPage(PreparationEdits& edits, PhotoCanvas& canvas, QWidget* parent = nullptr);

    void showLines(); ///< as they are drawn by now, and what can be done with them

signals:
    void failed(const QString& reason);

private:
    void layOut();
    void straighten();
    void load();
    void save();

    PreparationEdits& m_edits;
    PhotoCanvas& m_canvas;
    QComboBox* m_kind;
    QLabel* m_count;
    QPushButton *m_straighten, *m_clear, *m_load, *m_save;
};

} // namespace esm
