#include "widgets/inputs/number_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

QString withTrueMinus(QString text) {
    return text.replace('-', QChar(0x2212));
}

} // namespace

QString countText(std::size_t count) {
    QString text = QString::number(count);
    for (int i = text.size() - 3; i > 0; i -= 3)
        text.insert(i, QChar(0x2009));
    return text;
}

QString numberText(double value, int significantDigits) {
    if (!std::isfinite(value)) return QString(QChar(0x2013));
    if (value == 0) return QStringLiteral("0");
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (exponent < -4 || exponent > 6)
        return withTrueMinus(QString::number(value, 'e', significantDigits - 2));
    return decimalText(value, std::clamp(significantDigits - 1 - exponent, 0, 8));
}

QString decimalText(double value, int decimals) {
    if (!std::isfinite(value)) return QString(QChar(0x2013));
    const double unit = std::pow(10.0, -decimals);
    // "−0.0" is a rounding artefact nobody wants to read.
    if (std::abs(value) < unit / 2) value = 0;
    return withTrueMinus(QString::number(value, 'f', decimals));
}

std::optional<double> parseNumber(const QString& text) {
    static const QRegularExpression number(
        QStringLiteral("^\\s*([-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?)"));
    QString plain = text;
    plain.replace(QChar(0x2212), '-').replace(',', '.').remove(QChar(0x2009));
    const auto match = number.match(plain);
    if (!match.hasMatch()) return std::nullopt;
    bool valid = false;
    const double value = match.captured(1).toDouble(&valid);
    return valid && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace esm
