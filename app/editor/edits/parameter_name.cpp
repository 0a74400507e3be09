#include "app/editor/edits/parameter_name.h"

#include <QObject>

namespace esm {

QString parameterName(Parameter parameter, Extent extent) {
    switch (parameter) {
    case Parameter::SpringConstant:
        return QObject::tr("spring constant");
    case Parameter::Viscosity:
        return QObject::tr("viscosity");
    default:
        return extent == Extent::Base ? QObject::tr("base mass") : QObject::tr("region mass");
    }
}

} // namespace esm
