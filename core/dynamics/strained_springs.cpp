#include "core/dynamics/strained_springs.h"

#include <algorithm>
#include <functional>

namespace esm {

namespace {

bool becomesStiffer(const SpringSystem::Element& spring) {
    return largestSpringConstant(spring) > spring.springConstant;
}

/// Share of its strain from which on a spring is taken in as soon as others are beyond theirs. Where one
/// passes its strain the matrix is factorised anew, and its neighbours soon follow. Taken in ahead, many of
/// them cost one factorisation. Taken in much earlier, they would make the matrix stiffer than the tissue,
/// and its motion slower.
constexpr double nearShare = 0.8;

/// @param share of each spring's strain
std::vector<char> strainedAt(const SpringSystem& system, const Vectors& positions, double share) {
    std::vector<char> strained;
    strained.reserve(system.springs.size());
    for (const auto& spring : system.springs) {
        const double length = (positions[spring.first] - positions[spring.second]).norm();
        const auto& [strain, stiffConstant] = spring.secondPhase;
        strained.push_back(isBeyond({share * strain, stiffConstant}, spring.restLength / length) &&
                           becomesStiffer(spring));
    }
    return strained;
}

} // namespace

StrainedSprings::StrainedSprings(const SpringSystem& system)
    : m_canChange(std::any_of(system.springs.begin(), system.springs.end(), becomesStiffer)),
      m_isStrained(system.springs.size(), 0) {}

// Springs are let go only where those that are still needed have become the smaller half. To let each go as
// it slackens would factorise as often as tissue swings about its strain.
bool StrainedSprings::follow(const SpringSystem& system, const Vectors& positions) {
    const bool hasGrown = add(system, positions);
    std::vector<char> near = strainedAt(system, positions, nearShare);
    const auto needed = std::count(near.begin(), near.end(), 1);
    if (std::count(m_isStrained.begin(), m_isStrained.end(), 1) <= 2 * needed) return hasGrown;
    m_isStrained = std::move(near);
    return true;
}

bool StrainedSprings::add(const SpringSystem& system, const Vectors& positions) {
    const std::vector<char> strained = strainedAt(system, positions, 1);
    const auto isNew = [](char now, char known) { return now && !known; };
    if (std::equal(strained.begin(), strained.end(), m_isStrained.begin(), std::not_fn(isNew))) return false;
    const std::vector<char> near = strainedAt(system, positions, nearShare);
    for (std::size_t i = 0; i < near.size(); ++i)
        if (near[i]) m_isStrained[i] = 1;
    return true;
}

void StrainedSprings::addAll() {
    m_isStrained.assign(m_isStrained.size(), 1);
}

SpringSystem StrainedSprings::linearised(const SpringSystem& system) const {
    SpringSystem linear = system;
    for (std::size_t i = 0; i < linear.springs.size(); ++i) {
        auto& spring = linear.springs[i];
        if (m_isStrained[i]) spring.springConstant = largestSpringConstant(spring);
        spring.secondPhase = {};
    }
    return linear;
}

} // namespace esm
