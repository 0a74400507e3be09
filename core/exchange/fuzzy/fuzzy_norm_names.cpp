#include "core/exchange/fuzzy/fuzzy_norm_names.h"

#include "core/exchange/fuzzy/fuzzy_source.h"

#include <array>

namespace esm {

namespace {

/// In the order of both enumerations.
constexpr std::array<NormNames, 3> foreignTNorms{
    {{"MIN", "Minimum"}, {"PROD", "AlgebraicProduct"}, {"BDIF", "BoundedDifference"}}};
constexpr std::array<NormNames, 3> foreignTConorms{
    {{"MAX", "Maximum"}, {"ASUM", "AlgebraicSum"}, {"BSUM", "BoundedSum"}}};

template<class Norm>
std::optional<ForeignNorm<Norm>> foreignNorm(const std::array<NormNames, 3>& names, const std::string& name) {
    const std::string wanted = inSmallLetters(name);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (wanted == inSmallLetters(names[i].fcl) || wanted == inSmallLetters(names[i].fll))
            return ForeignNorm<Norm>{static_cast<Norm>(i)};
    return std::nullopt;
}

} // namespace

NormNames foreignNames(TNorm norm) {
    return foreignTNorms[static_cast<std::size_t>(norm)];
}

NormNames foreignNames(TConorm norm) {
    return foreignTConorms[static_cast<std::size_t>(norm)];
}

std::optional<ForeignNorm<TNorm>> foreignTNorm(const std::string& name) {
    return foreignNorm<TNorm>(foreignTNorms, name);
}

std::optional<ForeignNorm<TConorm>> foreignTConorm(const std::string& name) {
    const std::string wanted = inSmallLetters(name);
    if (wanted == "probor") return ForeignNorm<TConorm>{TConorm::ProbabilisticSum};
    for (const char* sum : {"nsum", "normalizedsum", "sum", "unboundedsum"})
        if (wanted == sum) return ForeignNorm<TConorm>{TConorm::BoundedSum, true};
    return foreignNorm<TConorm>(foreignTConorms, name);
}

} // namespace esm
