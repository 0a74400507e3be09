#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "widgets/inputs/number_field.h"
#include "widgets/texture/photo_canvas.h"

#include <QButtonGroup>
#include <QPushButton>

namespace esm {

/// What stands above a photo while its field is set: it is found, drawn, or mended by its handles.
class FieldPage : public QWidget {
    Q_OBJECT

public:
    FieldPage(PreparationEdits& edits, PhotoCanvas& canvas, QWidget* parent = nullptr);

    void showField(); ///< as it is by now

private:
    enum Shape { Circle, Ellipse, Polygon };

    void layOut();
    void choose(Shape shape);
    void setField(const QString& text, const std::optional<PhotoField>& field);

    PreparationEdits& m_edits;
    PhotoCanvas& m_canvas;
    QPushButton *m_find, *m_none;
    QButtonGroup* m_shapes;
    NumberField* m_trim;
};

} // namespace esm
