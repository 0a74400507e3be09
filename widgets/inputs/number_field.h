#pragma once

#include "widgets/inputs/gesture.h"

#include <QLineEdit>

#include <chrono>
#include <limits>
#include <optional>

namespace esm {

/// How a quantity is shown and what may be typed.
struct NumberFormat {
    QString unit;                                           ///< "mm"; may be empty
    bool showsUnit = true;                                  ///< false where a caption names the unit
    double shownPerValue = 1;                               ///< 1000 for a length in m that is shown in mm
    int decimals = -1;                                      ///< fixed; below zero, four significant digits
    double minimum = std::numeric_limits<double>::lowest(); ///< of the value, not of what is shown
    double maximum = std::numeric_limits<double>::max();
    double step = 0; ///< of the value, for the arrow keys; 0: a twentieth of the value
};

/// A right-aligned number with its unit. What is typed counts on Enter or when the field is left, in the
/// field's unit or another of the same quantity ("5 cm"); Escape takes it back; the arrow keys step. What is
/// no number, or lies out of range, is not taken: it stays to be corrected, marked, with the reason in the
/// tool tip.
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(NumberFormat format, QWidget* parent = nullptr);

    /// Shows a value without announcing it; none shows a dash, or what stands for it.
    void setValue(std::optional<double> value);
    void setEmptyText(const QString& text);
    std::optional<double> value() const { return m_value; }
    const NumberFormat& format() const { return m_format; }
    /// Another unit or other limits from now on; what is shown is neither announced nor refused.
    void setFormat(NumberFormat format);
    /// Why what stands in the field was not taken; empty when it was.
    const QString& refusal() const { return m_refusal; }
    /// What is being typed counts now, or is refused, as when the field is left.
    void takeTyped();
    /// Shows why what stands in the field was not taken, below it.
    void tellRefusal();

    /// How long the arrow keys rest before what follows is another edit.
    void setPause(std::chrono::milliseconds pause) { m_keys.setPause(pause); }

    QSize sizeHint() const override;
    /// Wide enough for every number with this unit, however large or small; pixels.
    int widthFor(const QString& unit) const;

signals:
    void valueEdited(double value);
    /// What was typed is taken, or the arrow keys rest: what follows is another edit.
    void gestureFinished();
    /// See refusal().
    void refusalChanged();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void take(double value);
    void refuse(const QString& reason);
    void setRefusal(const QString& reason);
    void showValue();
    QString boundText(double value) const;
    QString rangeText() const;
    /// "From 1 to 2000 mm".
    QString limitsText() const;
    /// What the tool tip says: why a text is not taken, else what is set here, in which unit and limits.
    QString explained() const;
    int textMargin() const;
    /// Whether the field has no room for all of its text: the tool tip then says it.
    bool isCut() const;

    NumberFormat m_format;
    std::optional<double> m_value;
    QString m_emptyText{QChar(0x2013)}, m_refusal;
    KeyRun m_keys{[this] { emit gestureFinished(); }};
};

} // namespace esm
