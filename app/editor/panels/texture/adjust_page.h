#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/value_slider.h"

#include <QGridLayout>
#include <QPushButton>

#include <vector>

namespace esm {

/// What stands above a photo while its colours are adjusted: a slider and a field for each number. The photo
/// follows while a slider moves.
class AdjustPage : public QWidget {
    Q_OBJECT

public:
    explicit AdjustPage(PreparationEdits& edits, QWidget* parent = nullptr);

    void showAdjustment(); ///< as it is by now

private:
    struct Control {
        double ColourAdjustment::*part;
        ValueSlider* slider;
        NumberField* field;
    };

    /// A caption, a slider of so many steps and a field, at the next place of two rows.
    /// @param name of the field; the slider's has "Slider" behind it
    Control& add(const QString& caption, double ColourAdjustment::*part, const char* name,
                 const NumberFormat& format, int steps);
    void connectControl(const Control& control);
    void set(double ColourAdjustment::*part, double value);
    void reset();

    PreparationEdits& m_edits;
    QGridLayout* m_grid;
    std::vector<Control> m_controls;
    QPushButton* m_reset;
};

/// In words of the panel: "hue 12°, contrast 120 %"; empty where nothing is adjusted.
QString adjustmentText(const ColourAdjustment& adjustment);

} // namespace esm
