#include "widgets/inputs/number_text.h"

#include "core/support/pressure_units.h"

#include <QHash>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

QString withTrueMinus(QString text) {
    return text.replace('-', QChar(0x2212));
}

enum class Quantity { Length, Mass, Force, SpringConstant, Viscosity, Modulus, Time, Angle };

struct UnitSize {
    Quantity quantity;
    double size; ///< in SI units; an angle's in degrees
};

std::optional<UnitSize> siUnitOf(const QString& unit) {
    static const QHash<QString, UnitSize> units{
        {QStringLiteral("µm"), {Quantity::Length, 1e-6}},
        {QStringLiteral("um"), {Quantity::Length, 1e-6}},
        {QStringLiteral("mm"), {Quantity::Length, 1e-3}},
        {QStringLiteral("cm"), {Quantity::Length, 1e-2}},
        {QStringLiteral("m"), {Quantity::Length, 1}},
        {QStringLiteral("mg"), {Quantity::Mass, 1e-6}},
        {QStringLiteral("g"), {Quantity::Mass, 1e-3}},
        {QStringLiteral("kg"), {Quantity::Mass, 1}},
        {QStringLiteral("mN"), {Quantity::Force, 1e-3}},
        {QStringLiteral("N"), {Quantity::Force, 1}},
        {QStringLiteral("N/m"), {Quantity::SpringConstant, 1}},
        {QStringLiteral("mN/m"), {Quantity::SpringConstant, 1e-3}},
        {QStringLiteral("N/mm"), {Quantity::SpringConstant, 1e3}},
        {QStringLiteral("N·s/m"), {Quantity::Viscosity, 1}},
        {QStringLiteral("Ns/m"), {Quantity::Viscosity, 1}},
        {QStringLiteral("N*s/m"), {Quantity::Viscosity, 1}},
        {QStringLiteral("Pa"), {Quantity::Modulus, 1}},
        {QStringLiteral("kPa"), {Quantity::Modulus, 1e3}},
        {QStringLiteral("MPa"), {Quantity::Modulus, 1e6}},
        {QStringLiteral("mmHg"), {Quantity::Modulus, pascalPerMillimetreOfMercury}},
        {QStringLiteral("cmH2O"), {Quantity::Modulus, pascalPerCentimetreOfWater}},
        {QStringLiteral("cmH₂O"), {Quantity::Modulus, pascalPerCentimetreOfWater}},
        {QStringLiteral("ms"), {Quantity::Time, 1e-3}},
        {QStringLiteral("s"), {Quantity::Time, 1}},
        {QStringLiteral("°"), {Quantity::Angle, 1}},
        {QStringLiteral("deg"), {Quantity::Angle, 1}},
    };
    const auto found = units.constFind(unit);
    return found != units.constEnd() ? std::optional(*found) : std::nullopt;
}

} // namespace

QString countText(std::size_t count) {
    QString text = QString::number(count);
    for (int i = text.size() - 3; i > 0; i -= 3)
        text.insert(i, QChar(0x202f)); // no line ends within a number
    return text;
}

QString numberText(double value, int significantDigits) {
    if (!std::isfinite(value)) return QString(QChar(0x2013));
    if (value == 0) return QStringLiteral("0");
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (exponent < -4 || exponent > 8)
        return withTrueMinus(QString::number(value, 'e', significantDigits - 1));
    return decimalText(value, std::clamp(significantDigits - 1 - exponent, 0, 8));
}

QString withUnit(double value, const QString& unit, int significantDigits) {
    const QString number = numberText(value, significantDigits);
    return unit.isEmpty() ? number : number + ' ' + unit;
}

QString decimalText(double value, int decimals) {
    if (!std::isfinite(value)) return QString(QChar(0x2013));
    const double unit = std::pow(10.0, -decimals);
    // "−0.0" is a rounding artefact nobody wants to read.
    if (std::abs(value) < unit / 2) value = 0;
    return withTrueMinus(QString::number(value, 'f', decimals));
}

std::optional<TypedNumber> readNumber(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral(
        "^\\s*([-+]?(?:\\d{1,3}(?:[ \\x{00a0}\\x{2009}\\x{202f}]\\d{3})+(?!\\d)|\\d+|(?=\\.\\d))"
        "(?:\\.\\d*)?(?:[eE][-+]?\\d+)?)(.*)$"));
    QString plain = text;
    const auto match = pattern.match(plain.replace(QChar(0x2212), '-').replace(',', '.'));
    if (!match.hasMatch()) return std::nullopt;
    const QString digits = match.captured(1).simplified().remove(' ');
    bool valid = false;
    const double number = digits.toDouble(&valid);
    if (!valid || !std::isfinite(number)) return std::nullopt;
    return TypedNumber{number, match.captured(2).trimmed()};
}

std::optional<double> unitRatio(const QString& from, const QString& to) {
    if (from == to) return 1.0;
    const auto source = siUnitOf(from), target = siUnitOf(to);
    if (!source || !target || source->quantity != target->quantity) return std::nullopt;
    return source->size / target->size;
}

} // namespace esm
