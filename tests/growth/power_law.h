#pragma once

#include <vector>

namespace growth {

struct Sample {
    double size, cost; ///< above zero
    double weight = 1; ///< how much its cost counts beside those of others
};

/// cost = factor · size^exponent, by weighted least squares of the logarithms.
struct PowerLaw {
    double exponent;
    double spread; ///< standard error of the exponent
};

/// Precondition: three samples or more.
PowerLaw fitPowerLaw(const std::vector<Sample>& samples);

/// The exponent between the last two.
double lastExponent(const std::vector<Sample>& samples);

} // namespace growth
