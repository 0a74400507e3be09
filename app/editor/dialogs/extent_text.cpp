#include "app/editor/dialogs/extent_text.h"

#include "core/authoring/import_unit.h"
#include "widgets/inputs/number_text.h"

#include <QObject>
#include <QStringList>

#include <algorithm>

namespace esm {

namespace {

QString lengthText(double metres) {
    return lengthsText({metres});
}

QString unitsName(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::Millimetre:
        return QObject::tr("millimetres");
    case LengthUnit::Centimetre:
        return QObject::tr("centimetres");
    case LengthUnit::Metre:
        break;
    }
    return QObject::tr("metres");
}

} // namespace

QString lengthsText(const std::vector<double>& metres) {
    const bool isLarge = *std::max_element(metres.begin(), metres.end()) >= 1;
    QStringList lengths;
    for (const double length : metres)
        lengths << (isLarge          ? numberText(length, 3)
                    : length >= 0.01 ? decimalText(length * 1000, 0)
                                     : numberText(length * 1000, 2));
    const QString text = lengths.join(QStringLiteral(" × "));
    return isLarge ? QObject::tr("%1 m").arg(text) : QObject::tr("%1 mm").arg(text);
}

QString doubtfulExtent(double largestExtent, LengthUnit unit) {
    const double metres = largestExtent * metresPer(unit);
    if (isPlausibleSize(metres)) return {};
    QStringList fitting;
    for (const auto& [other, size] : fittingUnits(largestExtent))
        fitting << QObject::tr("%1 in %2").arg(lengthText(size), unitsName(other));
    if (fitting.isEmpty())
        return QObject::tr("The organ would be %1 large, and no unit makes it an organ's size.")
            .arg(lengthText(metres));
    return QObject::tr("The organ would be %1 large. It would be %2.")
        .arg(lengthText(metres), fitting.join(QStringLiteral(", ")));
}

} // namespace esm
