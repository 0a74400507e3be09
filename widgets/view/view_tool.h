#pragma once

#include "widgets/view/sight.h"

#include <QObject>
#include <QPainter>
#include <QPalette>

#include <optional>

namespace esm {

/// Where the mouse is in the view, and the organ as it is seen there.
struct ToolMouse {
    Sight sight;
    QPointF place; ///< pixels
    Qt::KeyboardModifiers keys;
    std::optional<double> pressure{}; ///< of a tablet's pen, 0 to 1, while it is down; none of a mouse

    Ray ray() const { return sight.rayAt(place); }
    std::optional<PickedPoint> picked() const { return sight.pickAt(place); }
};

/// How what a press takes hold of follows the mouse.
enum class Hold {
    Nothing, ///< the view turns instead
    Drag,    ///< once the mouse went farther than a click may wander
    Stroke   ///< from the first pixel; a press is never a click
};

/// What the left mouse button does in the organ's view. The view tells the tool in hand what the user does;
/// the tool owns its drag and makes the edit. What it does not say is the view's: this one only turns it.
class ViewTool : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    virtual Hold press(const ToolMouse&) { return Hold::Nothing; }
    /// Whether a press with Shift is for the tool here. Elsewhere it shifts the view.
    virtual bool takesShift(const ToolMouse&) const { return false; }
    /// With what is held, or with nothing.
    virtual void move(const ToolMouse&) {}
    /// Ends what a press took hold of.
    virtual void release() {}
    /// The button came up where it went down, after release().
    virtual void click(const ToolMouse&) {}
    /// Esc, or another tool is taken.
    virtual void cancel() { release(); }
    /// The mouse left the view.
    virtual void leave() {}
    /// False leaves the wheel to the view.
    virtual bool wheel(const ToolMouse&, double /*notches*/) { return false; }

    /// Changes what is shown of the organ while the tool is in hand; again whenever it changed().
    virtual void dress(RenderScene&) const {}
    /// Paints over the organ.
    virtual void draw(QPainter&, const Sight&, const QPalette&) const {}
    /// Whether the box of the selected photo's projector is seen while the tool is in hand.
    virtual bool showsProjector() const { return false; }
    virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }

    /// Places, pixels, that a press takes hold of: Tab goes from one to the next where the keys work in place
    /// of the mouse.
    virtual std::vector<QPointF> stops(const Sight&) const { return {}; }

    /// What to do now, where that is not what the tool always says.
    virtual QString hint() const { return {}; }
    /// Why the tool cannot be taken now; empty where it can.
    virtual QString whyNot() const { return {}; }
    /// What can be set at the tool, seen while it is in hand; null where there is nothing. Stays the
    /// caller's.
    virtual QWidget* makeOptions() { return nullptr; }

signals:
    /// What it shows or says is another.
    void changed();
    /// Something for the line at the bottom.
    void message(const QString& text);
    /// Its work is done, and goes on with the tool of this name.
    void done(const QString& next);
};

} // namespace esm
