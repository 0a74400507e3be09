#include "core/model/stepping.h"

#include "core/support/numbers.h"

#include <cmath>

namespace esm {

namespace {

constexpr std::size_t tissueDigits = 16;
constexpr const char* hexadecimal = "0123456789abcdef";

} // namespace

const char* precisionName(Precision precision) {
    return precision == Precision::Float ? "float" : "double";
}

std::optional<Precision> precisionFromName(const std::string& name) {
    for (const Precision precision : {Precision::Double, Precision::Float})
        if (name == precisionName(precision)) return precision;
    return std::nullopt;
}

std::vector<std::string> validate(const Stepping& stepping) {
    std::vector<std::string> problems;
    if (!isPositive(stepping.timeStep))
        problems.emplace_back("the time step must be a number of seconds above zero");
    if (stepping.precision == Precision::Float && !mayBeExplicit(stepping.integrator))
        problems.push_back(
            std::string(integratorName(stepping.integrator)) +
            " computes in double precision: choose double or an explicit integrator, as euler");
    return problems;
}

std::vector<std::string> validate(const MeasuredStepping& measured) {
    std::vector<std::string> problems = validate(measured.stepping);
    if (measured.stepping.integrator == Integrator::Auto)
        problems.emplace_back("auto is not a measured integrator: name the one it became");
    if (!std::isfinite(measured.error) || measured.error < 0)
        problems.emplace_back("the error must be a number, 0 or more");
    if (!isPositive(measured.wallPerSimulatedSecond))
        problems.emplace_back("the wall time per simulated second must be a number above zero");
    if (!measured.tissue.empty() && (measured.tissue.size() != tissueDigits ||
                                     measured.tissue.find_first_not_of(hexadecimal) != std::string::npos))
        problems.emplace_back("the tissue it was measured on must be 16 hexadecimal digits");
    return problems;
}

} // namespace esm
