#include "app/editor/dialogs/sofa_trial_dialog.h"

#include "app/editor/dialogs/box_setup.h"
#include "core/support/numbers.h"
#include "widgets/inputs/number_text.h"
#include "widgets/plot/curve_chart.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace esm {

namespace {

constexpr double millimetresPerMetre = 1000, millisecondsPerSecond = 1000;
constexpr int figureDigits = 3;
constexpr double nearError = 0.01; ///< of the motion

ChartCurve wayOverTime(const QString& name, const SofaTrial& trial, const std::vector<double>& ways) {
    ChartCurve curve{name, {}};
    for (std::size_t i = 0; i < ways.size(); ++i)
        curve.points.push_back({trial.times[i], millimetresPerMetre * ways[i]});
    return curve;
}

QString textOfError(const SofaTrial& trial) {
    return QObject::tr("The motion in SOFA differs from that here by %1, over all nodes at %2 times.")
        .arg(QString::fromStdString(percentText(trial.error)))
        .arg(trial.times.size() - 1);
}

/// The error of SOFA's steps is of first order.
QString textOfVerdict(const SofaTrial& trial) {
    if (trial.error <= nearError) return QObject::tr("That is within 1 %: it moves there as it does here.");
    if (trial.error >= 1) return QObject::tr("That is not the same motion: try much shorter steps.");
    return QObject::tr("With steps half as long the difference is about half, unless it comes from what the "
                       "export leaves out.");
}

QString textOfTimes(const SofaTrial& trial) {
    return QObject::tr("By the clock a second of motion takes %1 s here, and %2 s in SOFA in steps of %3 ms; "
                       "other work on this computer makes that longer.")
        .arg(numberText(trial.wallHere, figureDigits), numberText(trial.wallThere, figureDigits),
             numberText(millisecondsPerSecond * trial.timeStep, figureDigits));
}

QLabel* figureLabel(const char* name, const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    return label;
}

} // namespace

SofaTrialDialog::SofaTrialDialog(const SofaTrial& trial, const QString& motion, QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("The organ in SOFA"));
    setObjectName(QStringLiteral("sofaTrialDialog"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    column->addWidget(figureLabel("sofaTrialMotion",
                                  tr("The organ is moved by %1. Shown is how far the node that moves "
                                     "farthest without being led is from its place at rest.")
                                      .arg(motion),
                                  this));
    auto* chart = new CurveChart(this);
    chart->setObjectName(QStringLiteral("sofaTrialChart"));
    chart->setAxes({tr("time"), QStringLiteral("s")}, {tr("distance"), QStringLiteral("mm")});
    chart->setCurves(
        {wayOverTime(tr("here"), trial, trial.here), wayOverTime(tr("in SOFA"), trial, trial.there)});
    chart->setToolTip(tr("The arrow keys go from one moment to the next"));
    chart->setMinimumSize(560, 300);
    column->addWidget(chart, 1);
    column->addWidget(
        figureLabel("sofaTrialError", textOfError(trial) + QLatin1Char(' ') + textOfVerdict(trial), this));
    auto* times = figureLabel("sofaTrialTimes", textOfTimes(trial), this);
    times->setProperty("quiet", true);
    column->addWidget(times);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    rejectOnEscape(*this);
}

} // namespace esm
