#pragma once

#include <QLineEdit>

#include <limits>
#include <optional>

namespace esm {

/// How a quantity is shown and what may be typed.
struct NumberFormat {
    QString unit;                                           ///< "mm"; may be empty
    double shownPerValue = 1;                               ///< 1000 for a length in m that is shown in mm
    int decimals = -1;                                      ///< fixed; below zero, four significant digits
    double minimum = std::numeric_limits<double>::lowest(); ///< of the value, not of what is shown
    double maximum = std::numeric_limits<double>::max();
    double step = 0; ///< of the value, for the arrow keys; 0: a twentieth of the value
};

/// A right-aligned number with its unit. What is typed counts on Enter or when the field is left; Escape
/// takes it back; the arrow keys step. What is no number, or lies out of range, is not taken.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(NumberFormat format, QWidget* parent = nullptr);

    /// Shows a value without announcing it; none shows a dash.
    void setValue(std::optional<double> value);
    std::optional<double> value() const { return m_value; }
    void setFormat(const NumberFormat& format);

    QSize sizeHint() const override;

signals:
    void valueEdited(double value);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    void takeText();
    void take(double value);
    void showValue();

    NumberFormat m_format;
    std::optional<double> m_value;
};

} // namespace esm
