#pragma once

#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QComboBox>
#include <QPushButton>

namespace esm {

class DistanceTool;

/// What is measured, and how long it truly is. For the tool Distance.
class DistancePanel : public Section {
    Q_OBJECT

public:
    explicit DistancePanel(DistanceTool& tool, QWidget* parent = nullptr);

private:
    void layOut();
    void show();
    void showScaling();

    DistanceTool& m_tool;
    QLabel* m_measured;
    NumberField* m_trueLength;
    QComboBox* m_kept;
    QPushButton* m_scale;
    QLabel* m_remark;
};

} // namespace esm
