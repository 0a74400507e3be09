#pragma once

#include <QString>

#include <cstddef>
#include <optional>

namespace esm {

/// "2 194": groups of three digits, so that large counts are read at a glance.
QString countText(std::size_t count);

/// A number with four significant digits and a true minus sign: "16.26", "−0.4000", "2.4e−07".
QString numberText(double value, int significantDigits = 4);

/// A fixed number of decimals, for columns that must line up.
QString decimalText(double value, int decimals);

/// The number at the start of a text; a decimal comma and a true minus are understood, a unit behind it is
/// skipped. Empty when there is none.
std::optional<double> parseNumber(const QString& text);

} // namespace esm
