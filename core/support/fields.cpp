#include "core/support/fields.h"

#include <cmath>

namespace esm {

/// What is at least the smallest number that there is, or one over the largest that is used, is above 0 for
/// people.
std::string limitsText(double least, double most, const std::string& unit) {
    constexpr int digits = 10;
    const std::string space = unit.empty() ? "" : " ";
    const auto text = [&](double value) { return roundedText(value, digits) + space + unit; };
    const bool isOpen = std::isinf(most), isAboveZero = least > 0 && least <= 1 / largestNumber;
    if (isOpen && least == std::numeric_limits<double>::lowest()) return "finite";
    if (!isOpen && !isAboveZero && (least != 0 || most < largestNumber))
        return "from " + roundedText(least, digits) + " to " + text(most);
    const std::string begins = isAboveZero ? "above 0" + space + unit : text(least) + " or more";
    return isOpen ? begins : begins + " and at most " + roundedText(most, digits);
}

} // namespace esm
