#include "core/support/numbers.h"

#include <sstream>

namespace esm {

std::string numberText(double value, int digits) {
    std::ostringstream text;
    text.precision(digits);
    text << value;
    return text.str();
}

} // namespace esm
