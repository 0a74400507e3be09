#pragma once

#include "app/editor/tools/painting.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

namespace esm {

/// What the brush does, how large and how soft it is. For the tool Brush.
class BrushPanel : public Section {
    Q_OBJECT

public:
    explicit BrushPanel(Painting& painting, QWidget* parent = nullptr);

private:
    void layOut();
    void connectFields();
    void show();
    void showKinds();
    QWidget* pressureBoxes();
    void usePressure();
    void showColour(const std::array<std::uint8_t, 3>& colour);
    QString remark() const;
    void change(const std::function<void(Painting::Brush&)>& change);
    void resizeBrush(double factor);
    void chooseColour();

    Painting& m_painting;
    QComboBox* m_kind;
    NumberField *m_radius, *m_softness, *m_strength;
    QCheckBox *m_pressureSize, *m_pressureStrength;
    QPushButton* m_colour;
    QLabel* m_remark;
};

} // namespace esm
