#include "widgets/inputs/quantity_formats.h"

namespace esm {

NumberFormat withoutUnit(NumberFormat format) {
    format.showsUnit = false;
    return format;
}

NumberFormat lengthFormat(double minimum) {
    NumberFormat format;
    format.unit = QStringLiteral("mm");
    format.shownPerValue = 1000;
    format.decimals = 1;
    format.minimum = minimum;
    format.maximum = 1000;
    format.step = 0.001;
    return format;
}

NumberFormat angleFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("°");
    format.decimals = 0;
    format.minimum = -360;
    format.maximum = 360;
    format.step = 1;
    return format;
}

QString turnedToolTip() {
    return QObject::tr("Turned about x, then y, then z, each about its own axis as turned so far");
}

NumberFormat modulusFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("kPa");
    format.shownPerValue = 1e-3;
    format.minimum = 0;
    format.maximum = 1e11;
    return format;
}

NumberFormat timeFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("s");
    format.minimum = 0;
    format.maximum = 1e6;
    return format;
}

NumberFormat forceFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("N");
    format.minimum = 1e-9;
    format.maximum = 1e6;
    return format;
}

NumberFormat massFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("kg");
    format.minimum = 1e-9;
    format.maximum = 1e4;
    return format;
}

NumberFormat percentFormat(double minimum, double maximum) {
    NumberFormat format;
    format.unit = QStringLiteral("%");
    format.shownPerValue = 100;
    format.minimum = minimum;
    format.maximum = maximum;
    return format;
}

NumberFormat wholePercentFormat(double maximum, double step) {
    NumberFormat format = percentFormat(0, maximum);
    format.decimals = 0;
    format.step = step;
    return format;
}

NumberFormat shareFormat() {
    return wholePercentFormat(1, 0.05);
}

NumberFormat pixelFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("px");
    format.decimals = 0;
    format.minimum = 0;
    format.maximum = 10000;
    format.step = 1;
    return format;
}

} // namespace esm
