#include "core/support/numbers.h"

#include <charconv>
#include <iterator>
#include <sstream>

namespace esm {

std::string exactText(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(std::begin(buffer), std::end(buffer), value);
    std::string text(buffer, error == std::errc() ? end : buffer);
    const std::size_t exponent = text.find('e');
    if (exponent != text.npos && text.find('.') == text.npos) text.insert(exponent, ".0");
    return text;
}

std::string roundedText(double value, int digits) {
    std::ostringstream text;
    text.precision(digits);
    text << value;
    return text.str();
}

std::string millimetresText(double metres, int digits) {
    const double shown = 1000 * metres;
    return (shown < 100 ? roundedText(shown, digits) : roundedText(std::round(shown))) + " mm";
}

std::string timeInText(double seconds) {
    constexpr int digits = 3;
    constexpr double roundsToOne = 0.9995;
    if (seconds >= 1000) return roundedText(std::round(seconds)) + " s";
    if (seconds >= roundsToOne) return roundedText(seconds, digits) + " s";
    if (seconds >= roundsToOne / 1000) return roundedText(1000 * seconds, digits) + " ms";
    return roundedText(1e6 * seconds, digits) + " µs";
}

double toTwoDigitsUp(double value) {
    const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
    return digit * std::ceil(value / digit);
}

std::string percentText(double share) {
    const double percents = 100 * share;
    const bool isWhole = percents >= 10 && percents < 1e6;
    return (isWhole ? roundedText(std::round(percents), 7) : roundedText(percents, 2)) + " %";
}

} // namespace esm
