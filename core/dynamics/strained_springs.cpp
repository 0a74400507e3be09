#include "core/dynamics/strained_springs.h"

#include <algorithm>

namespace esm {

namespace {

bool becomesStiffer(const SpringSystem::Element& spring) {
    return largestSpringConstant(spring) > spring.springConstant;
}

std::vector<char> strainedAt(const SpringSystem& system, const Vectors& positions) {
    std::vector<char> strained;
    strained.reserve(system.springs.size());
    for (const auto& spring : system.springs) {
        const double length = (positions[spring.first] - positions[spring.second]).norm();
        strained.push_back(isBeyond(spring.secondPhase, spring.restLength / length) &&
                           becomesStiffer(spring));
    }
    return strained;
}

} // namespace

StrainedSprings::StrainedSprings(const SpringSystem& system)
    : m_canChange(std::any_of(system.springs.begin(), system.springs.end(), becomesStiffer)),
      m_isStrained(system.springs.size(), 0) {}

bool StrainedSprings::follow(const SpringSystem& system, const Vectors& positions) {
    std::vector<char> strained = strainedAt(system, positions);
    const bool hasGrown = add(system, positions);
    const auto needed = std::count(strained.begin(), strained.end(), 1);
    if (std::count(m_isStrained.begin(), m_isStrained.end(), 1) <= 2 * needed) return hasGrown;
    m_isStrained = std::move(strained);
    return true;
}

bool StrainedSprings::add(const SpringSystem& system, const Vectors& positions) {
    const std::vector<char> strained = strainedAt(system, positions);
    bool hasGrown = false;
    for (std::size_t i = 0; i < strained.size(); ++i)
        if (strained[i] && !m_isStrained[i]) m_isStrained[i] = hasGrown = true;
    return hasGrown;
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
