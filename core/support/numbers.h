#pragma once

#include <cmath>
#include <string>

namespace esm {

/// Numbers of tissue and of fuzzy systems are no larger, and masses no smaller than one over it: squares and
/// products of a few of them then stay within what a double holds.
inline constexpr double largestNumber = 1e30;

/// Finite and above zero.
inline bool isPositive(double value) {
    return value > 0 && std::isfinite(value);
}

/// Zero up to the largest number: what a spring constant, a viscosity or a length may be.
inline bool isAmount(double value) {
    return value >= 0 && value <= largestNumber;
}

/// What a mass may be.
inline bool isMass(double value) {
    return value >= 1 / largestNumber && value <= largestNumber;
}

/// The shortest decimals that read back the same, with a point where there is an exponent, without which
/// other languages take it for no number.
std::string exactText(double value);

/// A number for people, with as many significant digits at most.
std::string roundedText(double value, int digits = 6);

/// A length for people, of so many significant digits at most: "0.35 mm"; from 100 mm on whole ones.
std::string millimetresText(double metres, int digits);

/// A time for people, of three significant digits at most: "2.59 µs", "50 ms", "1.5 s".
std::string timeInText(double seconds);

/// The next number up of two digits. Precondition: above 0.
double toTwoDigitsUp(double value);

/// A share in percent, for people: 0.0123 is "1.2 %", 3.345 is "335 %".
std::string percentText(double share);

} // namespace esm
