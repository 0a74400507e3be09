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

QString methodText(Integrator integrator) {
    switch (integrator) {
    case Integrator::Euler:
        return QObject::tr("euler, the simplest method; it needs small steps");
    case Integrator::Verlet:
        return QObject::tr("verlet, a simple method of second order; it needs small steps");
    case Integrator::Heun:
        return QObject::tr("heun, a method of second order; it needs small steps and some viscosity");
    case Integrator::Rk4:
        return QObject::tr("rk4, a very accurate method; it needs small steps");
    case Integrator::AdamsMoulton:
        return QObject::tr("adams-moulton, a very accurate method; it needs very small steps");
    case Integrator::Propagation:
        return QObject::tr("propagation, where forces settle node by node before the tissue moves on");
    case Integrator::Implicit:
        return QObject::tr(
            "implicit, a method that stays calm however stiff the tissue is, and calms its motion");
    case Integrator::Bdf2:
        return QObject::tr("bdf2, a method of second order that stays calm however stiff the tissue is");
    case Integrator::Projective:
        return QObject::tr(
            "projective, a fast method that lags behind where tissue turns; measure again for a better one");
    case Integrator::Split:
        return QObject::tr("split, a method that stays calm however viscous the tissue is");
    case Integrator::Split2:
        return QObject::tr("split2, a method of second order that stays calm however viscous the tissue is");
    case Integrator::Auto:
        break;
    }
    return QString();
}

} // namespace esm
