#include "app/editor/window/status_line.h"

#include "app/editor/panels/organ/stepping_text.h"
#include "core/dynamics/stability/stability.h"
#include "widgets/inputs/number_text.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QStyle>
#include <QVariant>

#include <cmath>
#include <utility>

namespace esm {

namespace {

/// Below this share of real time the tissue seems to stand still, and so long it may: a moment is no harm.
constexpr double slowestMotion = 0.1;
constexpr qint64 slowPatience = 2000; // ms

/// Why the motion is slow and what helps. Where the longest step would not help, it is for the number of
/// nodes.
QString slownessText(const PreviewStatus& status) {
    const QString speed = status.realTimeFactor < 0.01
                              ? QObject::tr("less than 0.01× real time")
                              : QObject::tr("%1× real time").arg(numberText(status.realTimeFactor, 1));
    return status.realTimeFactor * longestStep / status.timeStep < slowestMotion
               ? QObject::tr("%1: too many nodes").arg(speed)
               : QObject::tr("%1: the tissue is too stiff or too light; lower the spring constant, or raise "
                             "viscosity or mass")
                     .arg(speed);
}

/// That the motion ran wild, and how it goes on.
QString recoveryText(const PreviewStatus& status) {
    if (status.isReplaced)
        return QObject::tr(
            "The motion ran wild with the chosen method and step: the program chooses them now");
    if (status.halvings == 0) return QString();
    return QObject::tr(
               "The motion ran wild: it went back to where it was calm and on in shorter steps, of %1")
        .arg(durationText(status.timeStep));
}

/// That the motion is computed more finely than was chosen.
QString shorteningText(const PreviewStatus& status) {
    if (!status.isShortened) return QString();
    return QObject::tr("The chosen step is too long to be watched: the tissue moves in steps of %1 here")
        .arg(durationText(status.timeStep));
}

QString safeText(const PreviewStatus& status) {
    if (!status.safeStep) return QString();
    if (std::isinf(*status.safeStep)) return QObject::tr("safe at any step");
    return QObject::tr("safe up to %1").arg(durationText(*status.safeStep));
}

} // namespace

StabilityGauge::StabilityGauge(QWidget* parent) : QWidget(parent) {
    setFixedSize(92, 12);
}

void StabilityGauge::setShare(double share) {
    m_share = share;
    update();
}

void StabilityGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const QRectF bar(0, 3, width(), 6);
    QLinearGradient zones(bar.topLeft(), bar.topRight());
    const auto zone = [&](double from, double to, const QColor& colour) {
        zones.setColorAt(from, colour);
        zones.setColorAt(to, colour);
    };
    zone(0, 0.62, QColor(63, 170, 120));
    zone(0.621, 0.83, palette().color(QPalette::LinkVisited));
    zone(0.831, 1, palette().color(QPalette::BrightText));
    painter.setBrush(m_share < 0 ? QBrush(palette().color(QPalette::Mid)) : QBrush(zones));
    painter.drawRoundedRect(bar, 3, 3);
    if (m_share < 0) return;
    // The largest stable step lies where red begins.
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawRoundedRect(QRectF(qBound(0.0, m_share * 0.83, 1.0) * (width() - 3), 0, 3, 12), 1, 1);
}

StatusLine::Clock StatusLine::sinceStart() {
    QElapsedTimer timer;
    timer.start();
    return [timer] { return timer.elapsed(); };
}

StatusLine::StatusLine(QStatusBar& bar, Clock clock)
    : QObject(&bar), m_bar(bar), m_clock(std::move(clock)), m_since(m_clock()) {
    bar.setSizeGripEnabled(false);
    m_rate = addLabel(QStringLiteral("frameRate"), tr("000 fps"), tr("Pictures drawn per second"));
    m_realTime = addLabel(QStringLiteral("realTime"), tr("0000× real time"),
                          tr("How much faster than real time the tissue can be computed"));
    m_step = addLabel(QStringLiteral("stepping"), tr("step 00.00 ms"), {});
    m_message = new QLabel(&bar);
    m_message->setObjectName(QStringLiteral("message"));
    m_message->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    bar.addWidget(m_message, 1);
    m_stabilityCaption = new QLabel(tr("Stability"), &bar);
    m_gauge = new StabilityGauge(&bar);
    m_stability = new QLabel(&bar);
    m_stability->setMinimumWidth(m_stability->fontMetrics().horizontalAdvance(tr("safe up to 000 ms")) + 16);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_stabilityCaption, m_gauge, m_stability})
        bar.addPermanentWidget(widget);
    connect(&m_rateTimer, &QTimer::timeout, this, &StatusLine::showRate);
    m_rateTimer.start(1000);
    m_messageTimer.setSingleShot(true);
    connect(&m_messageTimer, &QTimer::timeout, this, &StatusLine::showLasting);
}

QLabel* StatusLine::addLabel(const QString& name, const QString& widestText, const QString& toolTip) {
    auto* label = new QLabel(&m_bar);
    label->setObjectName(name);
    label->setToolTip(toolTip);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widestText) + 18);
    m_bar.addWidget(label);
    return label;
}

void StatusLine::showRate() {
    const qint64 now = m_clock();
    const double seconds = double(now - std::exchange(m_since, now)) / 1000;
    m_rate->setText(tr("%1 fps").arg(qRound(m_pictures / seconds)));
    m_pictures = 0;
}

void StatusLine::showStatus(const PreviewStatus& status) {
    const bool moves = status.playing && status.realTimeFactor > 0;
    m_realTime->setText(moves ? tr("%1× real time").arg(numberText(status.realTimeFactor, 2)) : tr("paused"));
    m_step->setText(status.integrator ? tr("step %1").arg(durationText(status.timeStep)) : QString());
    m_stability->setText(safeText(status));
    explainStep(status);
    m_gauge->setShare(status.safeStep ? status.timeStep / *status.safeStep : -1);
    watchSpeed(status);
    const QString failure = QString::fromStdString(status.failure).replace('\n', QStringLiteral("; "));
    const QString recovery = recoveryText(status);
    const QString shortening = shorteningText(status);
    if (failure == m_failure && recovery == m_recovery && shortening == m_shortening) return;
    m_failure = failure;
    m_recovery = recovery;
    m_shortening = shortening;
    showLasting();
}

void StatusLine::watchSpeed(const PreviewStatus& status) {
    const bool isSlow = status.playing && status.realTimeFactor > 0 && status.realTimeFactor < slowestMotion;
    if (!isSlow)
        m_slowSince.reset();
    else if (!m_slowSince)
        m_slowSince = m_clock();
    const bool lasts = isSlow && m_clock() - *m_slowSince > slowPatience;
    const QString slowness = lasts ? slownessText(status) : QString();
    if (slowness == m_slowness) return;
    m_slowness = slowness;
    if (!m_messageTimer.isActive()) showLasting();
}

void StatusLine::explainStep(const PreviewStatus& status) {
    const QString step = durationText(status.timeStep);
    m_step->setToolTip(
        status.integrator
            ? tr("The motion is computed in steps of time: where every point of the tissue is %1 "
                 "later, and so on.\nMethod: %2.")
                  .arg(step, methodText(*status.integrator))
            : QString());
    QString gauge =
        tr("How safely the motion is computed. The mark is the step of time in use, red begins at the "
           "largest step that stays stable.\nBeyond it the tissue would swing ever wilder and fly apart; "
           "stiff or light tissue needs smaller steps. The program keeps below by itself.");
    if (status.safeStep && std::isinf(*status.safeStep))
        gauge = tr("How safely the motion is computed: this tissue stays stable whatever the step of time.");
    for (QWidget* widget : std::initializer_list<QWidget*>{m_stabilityCaption, m_gauge, m_stability})
        widget->setToolTip(gauge);
}

void StatusLine::showPictureFailure(const QString& reason) {
    if (reason == m_pictureFailure) return;
    m_pictureFailure = reason;
    showLasting();
}

void StatusLine::showJournalFailure(const QString& reason) {
    const QString text =
        reason.isEmpty() ? QString() : tr("Unsaved work is not being kept, save it yourself: %1").arg(reason);
    if (text == m_journalFailure) return;
    m_journalFailure = text;
    showLasting();
}

void StatusLine::showNote(const QString& note, const QString& explanation) {
    if (note == m_note && explanation == m_noteExplained) return;
    m_note = note;
    m_noteExplained = explanation;
    if (!m_messageTimer.isActive()) showLasting();
}

QString StatusLine::problem() const {
    for (const QString& text : {m_failure, m_pictureFailure, m_journalFailure, m_recovery})
        if (!text.isEmpty()) return text;
    return m_slowness;
}

void StatusLine::showLasting() {
    m_messageTimer.stop();
    const QString text = problem();
    if (!text.isEmpty())
        showText(text, text, true);
    else if (!m_shortening.isEmpty())
        showText(m_shortening, m_shortening, false);
    else
        showText(m_note, m_noteExplained, false);
}

void StatusLine::showMessage(const QString& text) {
    if (text.isEmpty()) return showLasting();
    showText(text, text, false);
    m_messageTimer.start(6000);
}

void StatusLine::showText(const QString& text, const QString& toolTip, bool warning) {
    if (m_message->property("warning").toBool() != warning) {
        m_message->setProperty("warning", warning);
        m_message->style()->unpolish(m_message);
        m_message->style()->polish(m_message);
    }
    m_message->setText(text);
    m_message->setToolTip(toolTip);
}

} // namespace esm
