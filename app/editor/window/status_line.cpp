#include "app/editor/window/status_line.h"

#include "app/editor/dialogs/sentence.h"
#include "app/editor/panels/measure/stepping_text.h"
#include "widgets/inputs/number_text.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QVariant>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace esm {

namespace {

constexpr int widestBarWithoutMethod = 1000; // pixels
constexpr int spacing = 6;                   // pixels, between the parts of a bar

/// Why the motion is not computed as was chosen, and how it goes on.
QString recoveryText(const PreviewStatus& status) {
    if (status.replaced == Replaced::BeyondSafe)
        return QObject::tr("The chosen step is not safe: the program chooses method and step now");
    if (status.replaced == Replaced::RanWild)
        return QObject::tr("The motion ran wild: the program chooses method and step now");
    if (status.halvings == 0) return QString();
    return QObject::tr(
               "The motion ran wild: it went back to where it was calm and on in shorter steps, of %1")
        .arg(durationText(status.timeStep));
}

/// That the motion is computed more finely than was chosen.
QString shorteningText(const PreviewStatus& status) {
    if (!status.isShortened) return QString();
    return QObject::tr("Shown in steps of %1: the chosen step is longer").arg(durationText(status.timeStep));
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

StatusLine::StatusLine(QStatusBar& bar, PassingTime clock)
    : QObject(&bar), m_bar(bar), m_clock(std::move(clock)), m_since(m_clock()) {
    bar.setSizeGripEnabled(false);
    m_rate = addLabel(QStringLiteral("frameRate"), tr("00 pictures/s"),
                      tr("How often the view is drawn. The tissue moves as fast however seldom that is."));
    m_realTime = addLabel(QStringLiteral("realTime"), tr("real speed, up to 0000×"), {});
    m_step = addLabel(QStringLiteral("stepping"), tr("00 ms steps"), {});
    m_message = new ElidedLabel(&bar);
    m_message->setObjectName(QStringLiteral("message"));
    bar.addWidget(m_message, 1);
    m_captionedGauge = new QWidget(&bar);
    m_gauge = new StabilityGauge(m_captionedGauge);
    auto* beside = new QHBoxLayout(m_captionedGauge);
    beside->setContentsMargins(0, 0, 0, 0);
    beside->setSpacing(spacing);
    beside->addWidget(new QLabel(tr("Stability"), m_captionedGauge));
    beside->addWidget(m_gauge);
    m_stability = new QLabel(&bar);
    m_stability->setMinimumWidth(m_stability->fontMetrics().horizontalAdvance(tr("safe up to 000 ms")) + 16);
    bar.addPermanentWidget(m_captionedGauge);
    bar.addPermanentWidget(m_stability);
    bar.installEventFilter(this);
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
    m_rate->setText(tr("%1 pictures/s").arg(qRound(m_pictures / seconds)));
    m_pictures = 0;
}

void StatusLine::showStatus(const PreviewStatus& status) {
    showSpeed(status);
    // In a narrow window the method is in the tool tip alone.
    const bool isNarrow = m_bar.width() < widestBarWithoutMethod;
    m_step->setText(!status.integrator ? QString()
                    : isNarrow         ? tr("%1 steps").arg(durationText(status.timeStep))
                                       : wayText(*status.integrator, status.timeStep));
    m_stability->setText(safeText(status));
    explainStep(status);
    m_gauge->setShare(status.safeStep ? status.timeStep / *status.safeStep : -1);
    const QString failure = sentence(status.failure).replace('\n', QStringLiteral("; "));
    const QString recovery = recoveryText(status);
    const QString shortening = shorteningText(status);
    if (failure == m_failure && recovery == m_recovery && shortening == m_shortening) return;
    m_failure = failure;
    m_recovery = recovery;
    m_shortening = shortening;
    showLasting();
}

void StatusLine::showSpeed(const PreviewStatus& status) {
    const double factor = status.realTimeFactor;
    const bool moves = status.playing && factor > 0;
    const bool isSlow = moves && factor < 1;
    setText(*m_realTime,
            isSlow  ? tr("%1 of real speed").arg(numberText(factor, 2))
            : moves ? tr("real speed, up to %1×").arg(numberText(factor, 2))
                    : tr("paused"),
            isSlow);
    m_realTime->setToolTip(
        isSlow ? tr("A second of the tissue's motion takes this machine %1 seconds to compute, so that it "
                    "is seen slowed down.")
                     .arg(numberText(1 / factor, 2))
               : tr("The tissue is seen to move as fast as it is. The machine could compute it so many "
                    "times as fast."));
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
    m_captionedGauge->setToolTip(gauge);
    m_stability->setToolTip(gauge);
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

void StatusLine::showWork(const QString& work) {
    if (work == m_work) return;
    m_work = work;
    if (!m_messageTimer.isActive()) showLasting();
}

QString StatusLine::problem() const {
    for (const QString& text : {m_failure, m_pictureFailure, m_journalFailure, m_recovery})
        if (!text.isEmpty()) return text;
    return {};
}

void StatusLine::showLasting() {
    m_messageTimer.stop();
    const QString text = problem();
    if (!text.isEmpty())
        showText(text, text, true);
    else if (!m_work.isEmpty())
        showText(m_work, m_work, false);
    else if (!m_shortening.isEmpty())
        showText(m_shortening, m_shortening, false);
    else
        showText(m_note, m_noteExplained, false);
}

void StatusLine::showMessage(const QString& text) {
    if (text.isEmpty()) return showLasting();
    showText(text, text, false);
    m_isAside = false;
    m_messageTimer.start(6000);
}

void StatusLine::showAside(const QString& text) {
    if (m_messageTimer.isActive() && !m_isAside) return;
    showMessage(text);
    m_isAside = true;
}

void StatusLine::showText(const QString& text, const QString& toolTip, bool warning) {
    setText(*m_message, text, warning);
    m_message->setToolTip(toolTip);
    makeRoom();
}

bool StatusLine::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) makeRoom();
    return false;
}

// What is told goes before what is always there: where both have no room, the least needed makes way.
void StatusLine::makeRoom() {
    const std::array<QWidget*, 5> parts{m_rate, m_stability, m_step, m_realTime, m_captionedGauge};
    m_message->ensurePolished();
    int missing =
        m_message->sizeHint().width() + spacing * (static_cast<int>(parts.size()) + 2) - m_bar.width();
    for (QWidget* part : parts) {
        part->ensurePolished();
        missing += std::max(part->minimumWidth(), part->sizeHint().width());
    }
    for (QWidget* part : parts) {
        part->setVisible(missing <= 0);
        if (missing > 0) missing -= std::max(part->minimumWidth(), part->sizeHint().width()) + spacing;
    }
}

void StatusLine::setText(QLabel& label, const QString& text, bool warning) {
    if (label.property("warning").toBool() != warning) {
        label.setProperty("warning", warning);
        label.style()->unpolish(&label);
        label.style()->polish(&label);
    }
    label.setText(text);
}

} // namespace esm
