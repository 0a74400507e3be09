#include "app/editor/panels/measure/work_news.h"

#include <QStyle>
#include <QVariant>
#include <QVBoxLayout>

namespace esm {

namespace {

constexpr int unsaidTime = 300;    // ms; most work on small organs is over by then
constexpr int linesOfMessage = 4;  // that the core's sentences need
constexpr int wholeProgress = 100; // of the bar

} // namespace

WorkNews::WorkNews(const QString& name, const QString& whatIsDone, QWidget* parent)
    : QStackedWidget(parent), m_message(new QLabel(this)), m_progress(new QProgressBar) {
    m_message->setObjectName(name + QStringLiteral("Message"));
    m_message->setWordWrap(true);
    m_message->setAlignment(Qt::AlignTop);
    m_message->ensurePolished();
    m_message->setMinimumHeight(linesOfMessage * m_message->fontMetrics().lineSpacing());
    m_progress->setObjectName(name + QStringLiteral("Progress"));
    m_progress->setAccessibleName(whatIsDone);
    m_progress->setMaximum(wholeProgress);
    auto* barOnTop = new QWidget(this);
    auto* column = new QVBoxLayout(barOnTop);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_progress);
    column->addStretch();
    addWidget(m_message);
    addWidget(barOnTop);
    m_patience.setSingleShot(true);
    m_patience.setInterval(unsaidTime);
    connect(&m_patience, &QTimer::timeout, this, &WorkNews::showPage);
}

void WorkNews::setProgress(std::optional<double> done) {
    if (done && !m_isWorking) m_patience.start();
    m_isWorking = done.has_value();
    m_progress->setValue(static_cast<int>(done.value_or(0) * wholeProgress));
    showPage();
}

void WorkNews::showPage() {
    setCurrentIndex(m_isWorking && !m_patience.isActive() ? 1 : 0);
}

void WorkNews::say(const QString& text, bool warns) {
    if (text == m_message->text() && warns == m_message->property("warning").toBool()) return;
    m_message->setText(text);
    m_message->setProperty("warning", warns);
    m_message->setProperty("quiet", !warns);
    m_message->style()->unpolish(m_message);
    m_message->style()->polish(m_message);
}

} // namespace esm
