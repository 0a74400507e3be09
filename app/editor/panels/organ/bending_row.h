#pragma once

#include "app/editor/document/document.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QCheckBox>

namespace esm {

/// Whether a hollow organ's surface resists bending: a check box and, where it does, how thick the wall is.
/// What is filled or rigid has no wall, and no such row.
class BendingRow : public QWidget {
    Q_OBJECT

public:
    explicit BendingRow(Document& document, QWidget* parent = nullptr);

private:
    void show();

    Document& m_document;
    QCheckBox* m_resists;
    ValueRows* m_numbers;
    NumberField* m_thickness;
    double m_last; ///< m, what the check box brings back
};

} // namespace esm
