#pragma once

#include "core/fuzzy/norms.h"

namespace esm {

/// What a norm is called in other languages: "MIN" in FCL, "Minimum" in FLL.
struct NormNames {
    const char *fcl, *fll;
};

NormNames foreignNames(TNorm norm);
NormNames foreignNames(TConorm norm);

/// A norm by either name in any case.
template<class Norm> struct ForeignNorm {
    Norm norm;
    bool isNear = false; ///< not the same, but one that comes near it
};

std::optional<ForeignNorm<TNorm>> foreignTNorm(const std::string& name);
std::optional<ForeignNorm<TConorm>> foreignTConorm(const std::string& name);

} // namespace esm
