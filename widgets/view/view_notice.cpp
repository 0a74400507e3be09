#include "widgets/view/view_notice.h"

#include "widgets/inputs/icon.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>

namespace esm {

namespace {

constexpr int fromEdge = 14, gap = 8; // pixels
// Pixels that the choice of what is shown takes at the left, and the axis cube at the right and above.
constexpr int besideChoice = 182, besideCube = 106, underCube = 78;
constexpr int widestNotice = 620, leastBeside = 320; // pixels

} // namespace

ViewNotice::ViewNotice(QWidget& view)
    : QFrame(&view), m_view(view), m_text(new QLabel(this)), m_help(new QPushButton(this)) {
    setObjectName(QStringLiteral("viewNotice"));
    m_text->setObjectName(QStringLiteral("viewNoticeText"));
    m_text->setWordWrap(true);
    m_help->setObjectName(QStringLiteral("viewNoticeHelp"));
    auto* dismiss = new QToolButton(this);
    dismiss->setObjectName(QStringLiteral("quietButton"));
    dismiss->setText(QString(QChar(0x00d7)));
    dismiss->setToolTip(tr("Take this notice away"));
    dismiss->setAccessibleName(dismiss->toolTip());
    // A click leaves the keys with the view.
    for (QWidget* button : std::initializer_list<QWidget*>{m_help, dismiss})
        button->setFocusPolicy(Qt::TabFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 8, 8);
    row->setSpacing(12);
    row->addWidget(m_text, 1);
    row->addWidget(m_help);
    row->addWidget(dismiss);
    connect(m_help, &QPushButton::clicked, this, &ViewNotice::helpAsked);
    connect(dismiss, &QToolButton::clicked, this, [this] {
        hide();
        emit dismissed();
    });
    view.installEventFilter(this);
    hide();
}

void ViewNotice::say(const QString& text, const QString& help, const QString& helpToolTip) {
    const bool isNews = isHidden() || text != m_text->text();
    m_text->setText(text);
    m_help->setText(help);
    m_help->setToolTip(helpToolTip);
    m_help->setVisible(!help.isEmpty());
    show();
    raise();
    placeAll();
    if (!isNews) return;
    QAccessibleEvent told(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&told);
}

void ViewNotice::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    placeAll();
}

void ViewNotice::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    placeAll();
}

bool ViewNotice::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) placeAll();
    return false;
}

// Between the choice of what is shown and the cube, in the middle if it can; below both where that is narrow.
void ViewNotice::placeAll() {
    int left = besideChoice, right = m_view.width() - besideCube, top = fromEdge;
    if (right - left < leastBeside) {
        left = fromEdge;
        right = m_view.width() - fromEdge;
        top = underCube;
    }
    for (ViewNotice* notice : m_view.findChildren<ViewNotice*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (notice->isHidden()) continue;
        notice->place(left, right, top);
        top += notice->height() + gap;
    }
}

void ViewNotice::place(int left, int right, int top) {
    const int width = std::min(right - left, widestNotice);
    layout()->activate();
    const int height =
        layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
    setGeometry(std::max(left, (m_view.width() - width) / 2), top, width, height);
}

} // namespace esm
