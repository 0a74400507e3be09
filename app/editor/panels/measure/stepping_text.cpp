#include "app/editor/panels/measure/stepping_text.h"

#include "widgets/inputs/number_text.h"

#include <QObject>

namespace esm {

QString durationText(double seconds) {
    return seconds >= 1e-4 ? QObject::tr("%1 ms").arg(numberText(seconds * 1000, 2))
                           : QObject::tr("%1 µs").arg(numberText(seconds * 1e6, 2));
}

QString methodName(const Stepping& stepping) {
    const QString title = QObject::tr(traitsOf(stepping.integrator).title);
    return stepping.precision == Precision::Float ? QObject::tr("%1, single precision").arg(title) : title;
}

QString steppingText(const Stepping& stepping) {
    return QObject::tr("%1\nstep %2").arg(methodName(stepping), durationText(stepping.timeStep));
}

QString wayText(Integrator integrator, double timeStep) {
    return QObject::tr("%1, %2 steps").arg(QObject::tr(traitsOf(integrator).title), durationText(timeStep));
}

QString methodText(Integrator integrator) {
    return QObject::tr(traitsOf(integrator).sentence);
}

QString figuresText(double realTimeFactor, double error, bool isErrorBound) {
    return (isErrorBound ? QObject::tr("%1× real time\n≤ %2 % error")
                         : QObject::tr("%1× real time\n%2 % error"))
        .arg(numberText(realTimeFactor, 2), numberText(100 * error, 2));
}

QString runText(const TradeoffRun& run) {
    QString text = steppingText(run.stepping);
    if (run.coarser) text = QObject::tr("%1, %2 nodes").arg(text, countText(run.nodes));
    return text + '\n' + figuresText(run.realTimeFactor(), run.error, run.isErrorBound);
}

} // namespace esm
