#include "core/fuzzy/norms.h"

namespace esm {

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

} // namespace esm
