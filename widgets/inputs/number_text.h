#pragma once

#include <QString>

#include <cstddef>
#include <optional>

namespace esm {

/// "2 194": groups of three digits, so that large counts are read at a glance.
QString countText(std::size_t count);

/// A number with at least four significant digits and a true minus sign: "16.26", "−0.4000", "2.400e−07".
QString numberText(double value, int significantDigits = 4);

/// "16.26 N/m"; the number alone where there is no unit.
QString withUnit(double value, const QString& unit, int significantDigits = 4);

/// A fixed number of decimals, for columns that must line up.
QString decimalText(double value, int decimals);

/// What was typed: a number, and whatever stands behind it.
struct TypedNumber {
    double number = 0;
    QString unit; ///< trimmed; empty when nothing follows
};

/// The number at the start of a text. A decimal comma, a true minus and spaces between groups of three digits
/// are understood. Empty when there is none.
std::optional<TypedNumber> readNumber(const QString& text);

/// How many of `to` one `from` is: 10 for "cm" to "mm", 1 for a unit to itself. Empty when the one cannot be
/// said in the other.
std::optional<double> unitRatio(const QString& from, const QString& to);

} // namespace esm
