#pragma once

#include "app/editor/document/document.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QCheckBox>

namespace esm {

/// Whether the organ's springs are biphasic: a check box and, where they are, beyond which stretch and by how
/// much they are stiffer. One law of all springs, in every region.
class StiffeningRow : public QWidget {
    Q_OBJECT

public:
    explicit StiffeningRow(Document& document, QWidget* parent = nullptr);

private:
    NumberField* addNumber(const QString& caption, const NumberFormat& format, double SpringStiffening::*part,
                           const QString& edit);
    void show();

    Document& m_document;
    QCheckBox* m_changes;
    ValueRows* m_numbers;
    NumberField *m_strain, *m_factor;
    SpringStiffening m_last; ///< what the check box brings back
};

} // namespace esm
