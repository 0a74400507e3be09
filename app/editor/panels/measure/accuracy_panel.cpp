#include "app/editor/panels/measure/accuracy_panel.h"

#include "app/editor/panels/measure/stepping_text.h"
#include "core/model/gentle_pull.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/refused_numbers.h"

namespace esm {

namespace {

NumberFormat computingFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("s");
    format.minimum = 0.01;
    format.maximum = 3600;
    return format;
}

} // namespace

AccuracyPanel::AccuracyPanel(Document& document, SpeedAndAccuracy& accuracy, QWidget* parent)
    : Section(tr("Speed and accuracy"), parent), m_document(document), m_accuracy(accuracy),
      m_measure(new QPushButton(this)), m_inUse(new QLabel(this)),
      m_automatic(addHeaderButton(tr("automatic"), {})), m_hint(new QLabel(this)),
      m_measured(buildMeasured()) {
    m_inUse->setObjectName(QStringLiteral("steppingInUse"));
    m_inUse->setWordWrap(true);
    m_hint->setObjectName(QStringLiteral("accuracyHint"));
    m_hint->setProperty("quiet", true);
    m_hint->setWordWrap(true);
    body()->addWidget(m_inUse);
    auto* measuredOn = new ValueRows(this);
    m_scene = measuredOn->addText(tr("motion compared"), QStringLiteral("measuredScene"));
    auto* mostSeconds = new NumberField(computingFormat(), this);
    mostSeconds->setObjectName(QStringLiteral("mostSeconds"));
    mostSeconds->setToolTip(
        tr("A run that would compute for longer is left out; the reference may take ten times as "
           "long. Large organs need more"));
    mostSeconds->setValue(m_accuracy.mostSecondsPerRun());
    connect(mostSeconds, &NumberField::valueEdited, &m_accuracy, &SpeedAndAccuracy::setMostSecondsPerRun);
    measuredOn->addField(tr("Time limit of a &run"), mostSeconds);
    body()->addWidget(measuredOn);
    body()->addWidget(m_hint);
    m_measure->setObjectName(QStringLiteral("measureButton"));
    m_measure->setToolTip(tr("Compute the motion by every method and step, and compare"));
    body()->addWidget(m_measure);
    body()->addWidget(m_measured);

    connect(m_measure, &QPushButton::clicked, this, [this] {
        if (takesAllNumbers(*this)) m_accuracy.measure(window());
    });
    connect(m_automatic, &QToolButton::clicked, &m_accuracy, &SpeedAndAccuracy::useAutomatic);
    connect(&m_accuracy, &SpeedAndAccuracy::changed, this, &AccuracyPanel::refresh);
    refresh();
}

QWidget* AccuracyPanel::buildMeasured() {
    auto* measured = new QWidget(this);
    m_mostError = new NumberField(percentFormat(1e-9, 1), measured);
    m_mostError->setObjectName(QStringLiteral("mostError"));
    m_mostError->setToolTip(tr("How far the motion may be off, as a part of the motion itself"));
    m_mostError->setValue(m_accuracy.wishes().mostError);
    m_inRealTime = new QPushButton(measured);
    m_inRealTime->setObjectName(QStringLiteral("inRealTime"));
    m_toError = new QPushButton(measured);
    m_toError->setObjectName(QStringLiteral("toError"));
    for (QPushButton* button : {m_inRealTime, m_toError}) // no wider than the column, whatever they say
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);

    auto* rows = new ValueRows(measured);
    rows->addWideField(tr("In real time, with the least error"), m_inRealTime);
    rows->addField(tr("Err&or at most"), m_mostError);
    rows->addWideField(tr("Within that error, the fastest"), m_toError);
    auto* column = new QVBoxLayout(measured);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(rows);

    connect(m_mostError, &NumberField::valueEdited, &m_accuracy, &SpeedAndAccuracy::setMostError);
    connect(m_inRealTime, &QPushButton::clicked, this,
            [this] { m_accuracy.use(*m_accuracy.tradeoff()->bestInRealTime, window()); });
    connect(m_toError, &QPushButton::clicked, this,
            [this] { m_accuracy.use(*m_accuracy.tradeoff()->fastestToError, window()); });
    return measured;
}

QString AccuracyPanel::hint() const {
    const Tradeoff* tradeoff = m_accuracy.tradeoff();
    if (m_accuracy.isOutdated()) return tr("Tissue or scene have changed since: measure again to be sure.");
    if (!tradeoff)
        return tr("How fast and how exactly can this machine compute the motion? Measure every method, then "
                  "choose one.");
    return tradeoff->reference.hidesSwings
               ? tr("Fast swings of tissue with next to no viscosity could not be followed: no error here "
                    "contains them.")
               : QString();
}

void AccuracyPanel::refresh() {
    const Tradeoff* tradeoff = m_accuracy.tradeoff();
    m_measured->setVisible(tradeoff != nullptr);
    m_measure->setText(tradeoff ? tr("Measure again") : tr("Measure"));
    const QString said = hint();
    m_hint->setVisible(!said.isEmpty());
    m_hint->setText(said);
    const Scene& scene = m_document.project().scene;
    m_scene->setText(movesTissue(scene)
                         ? tr("the scene, %1").arg(withUnit(scene.duration, QStringLiteral("s"), 2))
                         : tr("a gentle pull, 1 s"));
    m_scene->setToolTip(
        movesTissue(scene)
            ? tr("The project's own scene")
            : tr("Nothing in the scene moves the organ: a patch at its edge is drawn outwards"));
    showInUse();
    if (!tradeoff) return;
    showRecommendation(m_inRealTime, tradeoff->bestInRealTime, tr("None is as fast as real time"));
    showRecommendation(m_toError, tradeoff->fastestToError, tr("None is as exact"));
}

void AccuracyPanel::showInUse() {
    const auto& inUse = m_document.project().stepping;
    const auto run = m_accuracy.runInUse();
    if (run)
        m_inUse->setText(runText(m_accuracy.tradeoff()->runs[*run]));
    else
        m_inUse->setText(inUse ? steppingText(inUse->stepping) + '\n' +
                                     figuresText(1 / inUse->wallPerSimulatedSecond, inUse->error)
                               : tr("Method and step\nchosen by the program"));
    m_inUse->setToolTip(inUse ? methodText(inUse->stepping.integrator) : QString());
    enable(m_automatic, inUse.has_value(), tr("Let the program choose method and step again"),
           tr("The program already chooses method and step"));
}

void AccuracyPanel::showRecommendation(QPushButton* button, std::optional<std::size_t> run,
                                       const QString& none) {
    button->setText(run ? runText(m_accuracy.tradeoff()->runs[*run]) : none);
    enable(button, run.has_value(), tr("Use this method and step"), none);
}

} // namespace esm
