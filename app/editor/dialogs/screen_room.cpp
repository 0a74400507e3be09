#include "app/editor/dialogs/screen_room.h"

#include <QDialog>
#include <QEvent>
#include <QScreen>

#include <algorithm>

namespace esm {

namespace {

constexpr QSize windowFrame(4, 44); ///< pixels; what a desktop draws around a window, at most

int placed(int wanted, int least, int most) {
    return std::max(least, std::min(wanted, most));
}

void moveOntoScreen(QWidget& window) {
    const QRect screen = window.screen()->availableGeometry();
    const QSize outer = window.size() + windowFrame;
    QPoint corner = window.pos();
    if (!window.testAttribute(Qt::WA_Moved)) {
        const QRect beneath = window.parentWidget()->window()->frameGeometry();
        corner = beneath.center() - QPoint(outer.width(), outer.height()) / 2;
    }
    window.move(placed(corner.x(), screen.left(), screen.right() + 1 - outer.width()),
                placed(corner.y(), screen.top(), screen.bottom() + 1 - outer.height()));
}

class ScreenFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Show || event->spontaneous() || !watched->isWidgetType()) return false;
        auto& window = *static_cast<QWidget*>(watched);
        const bool isBeside = window.windowType() == Qt::Dialog || window.windowType() == Qt::Tool;
        if (!isBeside) return false;
        const QSize room = roomOnScreen(window);
        const QSize least = window.minimumSize().boundedTo(room), size = window.size().boundedTo(room);
        if (least != window.minimumSize()) window.setMinimumSize(least);
        if (size != window.size()) window.resize(size);
        // A dialog looks for a place on the screen itself.
        if (window.parentWidget() && !qobject_cast<QDialog*>(watched)) moveOntoScreen(window);
        return false;
    }
};

} // namespace

QSize roomOnScreen(const QWidget& window) {
    return window.screen()->availableSize() - windowFrame;
}

void keepWindowsOnScreen(QApplication& application) {
    application.installEventFilter(new ScreenFilter(&application));
}

} // namespace esm
