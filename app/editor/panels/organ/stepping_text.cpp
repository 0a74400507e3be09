#include "app/editor/panels/organ/stepping_text.h"

#include "widgets/inputs/number_text.h"

#include <QObject>

namespace esm {

QString durationText(double seconds) {
    return seconds >= 1e-4 ? QObject::tr("%1 ms").arg(numberText(seconds * 1000, 2))
                           : QObject::tr("%1 µs").arg(numberText(seconds * 1e6, 2));
}

QString steppingText(const Stepping& stepping) {
    const QString text =
        QObject::tr("%1, step %2")
            .arg(QString::fromLatin1(integratorName(stepping.integrator)), durationText(stepping.timeStep));
    return stepping.precision == Precision::Float ? QObject::tr("%1, single precision").arg(text) : text;
}

QString wayText(Integrator integrator, double timeStep) {
    return QObject::tr("%1, %2 steps").arg(QObject::tr(traitsOf(integrator).title), durationText(timeStep));
}

QString methodText(Integrator integrator) {
    return QObject::tr(traitsOf(integrator).sentence);
}

} // namespace esm
