#include "core/fuzzy/normal_form.h"

#include "core/support/joined.h"

#include <algorithm>

namespace esm {

namespace {

using Kind = FuzzyCondition::Kind;

/// What the norms let be rewritten. All t-norms and t-conorms are commutative and associative, so parts may
/// be sorted and brackets of the same kind opened whatever the norms. Only the minimum and the maximum are
/// idempotent: with the product a AND a is a², not a. NOT goes into brackets only where AND and OR are dual.
/// Nothing is distributed, since that holds for minimum and maximum alone and lets conditions grow
/// exponentially: what is found equal is equal, but not all that is equal is found.
struct Rewriting {
    explicit Rewriting(const FuzzyNorms& norms)
        : drawsNotIn(areDual(norms)), andIsIdempotent(norms.conjunction == TNorm::Minimum),
          orIsIdempotent(norms.disjunction == TConorm::Maximum) {}

    bool drawsNotIn; ///< AND and OR are dual
    bool andIsIdempotent, orIsIdempotent;

    std::string written(const FuzzyCondition& condition, bool isNegated) const {
        if (condition.kind == Kind::Not) return written(condition.parts.front(), !isNegated);
        if (condition.kind == Kind::Is)
            return (isNegated ? "!" : "") + std::to_string(condition.proposition.variable) + "." +
                   std::to_string(condition.proposition.term);
        if (isNegated && !drawsNotIn) return "!" + written(condition, false);
        const Kind kind = isNegated ? opposite(condition.kind) : condition.kind;
        std::vector<std::string> parts;
        collect(parts, condition, kind, isNegated);
        std::sort(parts.begin(), parts.end());
        if (kind == Kind::And ? andIsIdempotent : orIsIdempotent)
            parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        if (parts.size() == 1) return parts.front();
        return (kind == Kind::And ? "and(" : "or(") + joined(parts) + ")";
    }

private:
    static Kind opposite(Kind kind) { return kind == Kind::And ? Kind::Or : Kind::And; }

    /// The parts, and those of parts that are joined the same way.
    void collect(std::vector<std::string>& parts, const FuzzyCondition& condition, Kind kind,
                 bool isNegated) const {
        for (const FuzzyCondition& part : condition.parts) {
            const FuzzyCondition* inner = &part;
            bool innerNegated = isNegated;
            for (; inner->kind == Kind::Not; inner = &inner->parts.front())
                innerNegated = !innerNegated;
            const bool canOpen = inner->kind != Kind::Is && (!innerNegated || drawsNotIn);
            const bool isSame = canOpen && (innerNegated ? opposite(inner->kind) : inner->kind) == kind;
            if (isSame)
                collect(parts, *inner, kind, innerNegated);
            else
                parts.push_back(written(part, isNegated));
        }
    }
};

} // namespace

std::string normalForm(const FuzzyCondition& condition, const FuzzyNorms& norms) {
    return Rewriting(norms).written(condition, false);
}

} // namespace esm
