#include "tests/growth/power_law.h"

#include <cmath>

namespace growth {

PowerLaw fitPowerLaw(const std::vector<Sample>& samples) {
    double weights = 0, meanSize = 0, meanCost = 0;
    for (const Sample& sample : samples) {
        weights += sample.weight;
        meanSize += sample.weight * std::log(sample.size);
        meanCost += sample.weight * std::log(sample.cost);
    }
    meanSize /= weights;
    meanCost /= weights;
    double width = 0, together = 0;
    for (const Sample& sample : samples) {
        const double offset = std::log(sample.size) - meanSize;
        width += sample.weight * offset * offset;
        together += sample.weight * offset * (std::log(sample.cost) - meanCost);
    }
    const double exponent = together / width;
    double residuals = 0;
    for (const Sample& sample : samples) {
        const double expected = meanCost + exponent * (std::log(sample.size) - meanSize);
        residuals += sample.weight * std::pow(std::log(sample.cost) - expected, 2);
    }
    const auto count = static_cast<double>(samples.size());
    return {exponent, std::sqrt(residuals / (count - 2) / width)};
}

double lastExponent(const std::vector<Sample>& samples) {
    const Sample &last = samples.back(), &before = *(samples.end() - 2);
    return std::log(last.cost / before.cost) / std::log(last.size / before.size);
}

} // namespace growth
