#include "core/model/stepping.h"

namespace esm {

namespace {

/// 64 bits, four to a digit: what tissueDigest() writes.
constexpr std::size_t tissueDigits = 16;
constexpr const char* hexadecimal = "0123456789abcdef";

} // namespace

// Single precision is the explicit kernel's alone. Solving loses the more digits the worse a matrix is
// conditioned, and there would be seven to lose.
std::vector<std::string> validate(const Stepping& stepping) {
    std::vector<std::string> problems = fieldProblems(stepping);
    if (stepping.precision == Precision::Float && !mayBeExplicit(stepping.integrator))
        problems.push_back(
            std::string(integratorName(stepping.integrator)) +
            " computes in double precision: choose double or an explicit integrator, as euler");
    return problems;
}

// What a file says is not believed: digits that no tissue can have would only look like other tissue.
std::vector<std::string> validate(const MeasuredStepping& measured) {
    std::vector<std::string> problems = validate(measured.stepping);
    if (measured.stepping.integrator == Integrator::Auto)
        problems.emplace_back("auto is not a measured integrator: name the one it became");
    for (std::string& problem : fieldProblems(measured))
        problems.push_back(std::move(problem));
    if (!measured.tissue.empty() && !isTissueDigest(measured.tissue))
        problems.emplace_back("the tissue it was measured on must be 16 hexadecimal digits");
    return problems;
}

bool isTissueDigest(const std::string& digits) {
    return digits.size() == tissueDigits && digits.find_first_not_of(hexadecimal) == std::string::npos;
}

} // namespace esm
