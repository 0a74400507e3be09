#include "core/fuzzy/norms.h"

#include "core/support/joined.h"

#include <array>

namespace esm {

namespace {

/// In the order of both enumerations. They are the three pairs that FCL (IEC 61131-7) has words for, so that
/// systems go to files of others and back.
constexpr std::array<const char*, 3> tNorms{"minimum", "product", "bounded-difference"};
constexpr std::array<const char*, 3> tConorms{"maximum", "probabilistic-sum", "bounded-sum"};

template<class Norm>
std::optional<Norm> normFromName(const std::array<const char*, 3>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Norm>(found - names.begin());
}

} // namespace

/// De Morgan's laws hold for minimum and maximum, for product and probabilistic sum and for Łukasiewicz's
/// two, each pair by 1 − T(1 − a, 1 − b) = S(a, b) [R B.1, B.2].
TConorm dual(TNorm norm) {
    return static_cast<TConorm>(norm); // they stand at the same places
}

TNorm dual(TConorm norm) {
    return static_cast<TNorm>(norm);
}

bool areDual(const FuzzyNorms& norms) {
    return dual(norms.conjunction) == norms.disjunction;
}

const char* normName(TNorm norm) {
    return tNorms[static_cast<std::size_t>(norm)];
}

const char* normName(TConorm norm) {
    return tConorms[static_cast<std::size_t>(norm)];
}

std::optional<TNorm> tNormFromName(const std::string& name) {
    return normFromName<TNorm>(tNorms, name);
}

std::optional<TConorm> tConormFromName(const std::string& name) {
    return normFromName<TConorm>(tConorms, name);
}

std::string tNormNames() {
    return joined({tNorms.begin(), tNorms.end()});
}

std::string tConormNames() {
    return joined({tConorms.begin(), tConorms.end()});
}

} // namespace esm
