#include "widgets/view/view_caption.h"

#include <QEvent>

namespace esm {

namespace {

constexpr int captionFromEdge = 12; // pixels

}

ViewCaption::ViewCaption(QWidget& view, const QString& text) : QLabel(text, &view), m_view(view) {
    setObjectName(QStringLiteral("viewCaption"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    view.installEventFilter(this);
}

bool ViewCaption::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return false;
}

void ViewCaption::showEvent(QShowEvent* event) {
    QLabel::showEvent(event);
    place();
}

void ViewCaption::place() {
    adjustSize();
    move((m_view.width() - width()) / 2, captionFromEdge);
}

} // namespace esm
