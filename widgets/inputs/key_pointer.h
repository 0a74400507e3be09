#pragma once

#include <QKeyEvent>
#include <QPainter>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

namespace esm {

/// Works in a widget with the keys as with the mouse. The arrow keys move a mark over it, with Shift by a
/// pixel; Enter presses the left button there and lets it go again; Page Up and Page Down turn the wheel;
/// Tab goes from one place that can be taken hold of to the next. The keys that are held at Enter count as
/// held until it is let go. The mark is seen from the first arrow key until the mouse moves, the keys leave
/// or Esc is pressed.
class KeyPointer : public QObject {
    Q_OBJECT

public:
    explicit KeyPointer(QWidget& area);

    /// The places, pixels, that Tab goes to while the mark is seen, in their order.
    void setStops(std::function<std::vector<QPointF>()> stops) { m_stops = std::move(stops); }
    /// Nothing while the mark is not seen; pixels.
    std::optional<QPointF> place() const;
    bool isPressing() const { return m_isPressing; }

    /// Draws a frame around the area where Tab brought the keys there.
    void paintFocus(QPainter& painter) const;

    /// Whether the key was for the mark.
    bool press(const QKeyEvent& key);
    /// Goes to the next place or the one before; false where none is left, or no mark is seen.
    bool goToNextStop(bool forwards);
    /// Takes the mark away, and lets the button go where it is pressed.
    void hide();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show();
    void moveTo(const QPointF& place);
    void moveBy(const QKeyEvent& key);
    void toggle(Qt::KeyboardModifiers keys);
    void followFocus(const QEvent& event);
    void turnWheel(int notches, Qt::KeyboardModifiers keys);
    void send(QEvent::Type type, Qt::MouseButton button);

    QWidget& m_area;
    QWidget* m_mark;
    std::function<std::vector<QPointF>()> m_stops;
    std::optional<QPointF> m_place; ///< where it is, or was last
    Qt::KeyboardModifiers m_keys;   ///< that count as held
    bool m_isPressing = false;
    bool m_cameByTab = false;
    bool m_isSending = false; ///< what comes now is not the mouse's
};

} // namespace esm
