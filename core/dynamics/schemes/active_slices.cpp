#include "core/dynamics/schemes/active_slices.h"

#include "core/dynamics/settling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace esm {

namespace {

/// Of the tolerance, what a node may still have to go when it is left to rest. It is much less than all of
/// it: what is left off at each node adds up, and across flat tissue, where next to nothing brings nodes
/// back, they go farther than their springs tell.
constexpr double restingShare = 0.05;

/// The slices that springs join, in both directions and each once.
std::vector<std::pair<std::uint32_t, std::uint32_t>> joinedSlices(const SpringSystem& system,
                                                                  const std::vector<std::uint32_t>& sliceOf) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto& spring : system.springs) {
        const std::uint32_t first = sliceOf[spring.first], second = sliceOf[spring.second];
        if (first == second) continue;
        pairs.emplace_back(first, second);
        pairs.emplace_back(second, first);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

template<class Real> Real norm(const Real (&components)[4]) {
    return std::sqrt(components[0] * components[0] + components[1] * components[1] +
                     components[2] * components[2]);
}

} // namespace

// A wall bends as slowly as it is long and thin, far more slowly than its springs tell: left to rest by
// these, a strip that hangs down would stop half-way.
template<class Real>
ActiveSlices<Real>::ActiveSlices(const SpringSystem& system, const TissueKernel<Real>& kernel,
                                 double tolerance)
    : m_leastWay(system.hinges.empty() ? static_cast<Real>(restingShare * tolerance) : 0),
      m_isActive(kernel.sliceCount()) {
    activateAll();
    if (m_leastWay <= 0) return;
    std::vector<std::uint32_t> sliceOf(kernel.nodeCount());
    for (std::size_t node = 0; node < sliceOf.size(); ++node)
        sliceOf[node] = static_cast<std::uint32_t>(kernel.sliceOf(node));
    m_starts.assign(kernel.sliceCount() + 1, 0);
    for (const auto& [slice, neighbour] : joinedSlices(system, sliceOf)) {
        ++m_starts[slice + 1];
        m_neighbours.push_back(neighbour);
    }
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());

    m_slowness.assign(kernel.sliceCount() * kernel::sliceHeight, Slowness{0, 0});
    const std::vector<Settling> settling = settlingOf(system);
    // What nothing brings back goes on as long as it moves at all.
    constexpr auto forEver = static_cast<double>(std::numeric_limits<Real>::max() / 4);
    for (std::size_t node = 0; node < settling.size(); ++node) {
        const auto& [waveTime, driftTime] = settling[node];
        m_slowness[kernel.rowOf(node)] = {static_cast<Real>(std::min(waveTime + driftTime, forEver)),
                                          static_cast<Real>(std::min(waveTime * waveTime, forEver))};
    }
}

template<class Real> double ActiveSlices<Real>::fraction() const {
    return m_isActive.empty() ? 1
                              : static_cast<double>(m_active.size()) / static_cast<double>(m_isActive.size());
}

template<class Real> void ActiveSlices<Real>::activateAll() {
    m_isActive.assign(m_isActive.size(), 1);
    m_active.resize(m_isActive.size());
    std::iota(m_active.begin(), m_active.end(), 0U);
    m_border.clear();
}

template<class Real>
template<class Visit>
void ActiveSlices<Real>::forNeighbours(std::size_t slice, const Visit& visit) const {
    for (std::uint32_t i = m_starts[slice]; i < m_starts[slice + 1]; ++i)
        visit(m_neighbours[i]);
}

// Whether a slice still moves is asked of how far it has to go, not of how fast it is: viscous tissue creeps
// slowly, but for long, and a limit on speed would stop it half-way. Speed and acceleration are both asked,
// since a node at its turning point is not at rest. The condition is written so that a velocity that is not a
// number keeps its slice awake, where the run's guards find it.
template<class Real>
bool ActiveSlices<Real>::moves(std::size_t slice, const State& before, const State& state,
                               double timeStep) const {
    for (std::size_t row = slice * kernel::sliceHeight; row < (slice + 1) * kernel::sliceHeight; ++row) {
        const auto& velocity = state[row].velocity;
        const auto& former = before[row].velocity;
        const Real change[4] = {velocity[0] - former[0], velocity[1] - former[1], velocity[2] - former[2], 0};
        const Real way = norm(velocity) * m_slowness[row].perVelocity +
                         norm(change) / static_cast<Real>(timeStep) * m_slowness[row].perAcceleration;
        if (!(way <= m_leastWay)) return true;
    }
    return false;
}

template<class Real> void ActiveSlices<Real>::findBorder() {
    m_border.clear();
    for (const std::uint32_t slice : m_active) {
        bool isBorder = false;
        forNeighbours(slice, [&](std::uint32_t neighbour) { isBorder = isBorder || !m_isActive[neighbour]; });
        if (isBorder) m_border.push_back(slice);
    }
}

// A ring of neighbours is kept awake around what moves. One evaluation of the forces carries motion no
// farther than along the springs of a node, so that it cannot pass the ring unseen: follow() asks the slices
// of the border alone, which costs next to nothing in every step, and release() looks at all that is active
// now and then.
template<class Real>
typename ActiveSlices<Real>::SliceList ActiveSlices<Real>::release(const State& before, const State& state,
                                                                   double timeStep) {
    if (m_leastWay <= 0) return {};
    SliceList moving;
    std::copy_if(m_active.begin(), m_active.end(), std::back_inserter(moving),
                 [&](std::uint32_t slice) { return moves(slice, before, state, timeStep); });
    m_isActive.assign(m_isActive.size(), 0);
    for (const std::uint32_t slice : moving) {
        m_isActive[slice] = 1;
        forNeighbours(slice, [&](std::uint32_t neighbour) { m_isActive[neighbour] = 1; });
    }
    SliceList resting;
    std::copy_if(m_active.begin(), m_active.end(), std::back_inserter(resting),
                 [&](std::uint32_t slice) { return !m_isActive[slice]; });
    m_active.clear();
    for (std::uint32_t slice = 0; slice < m_isActive.size(); ++slice)
        if (m_isActive[slice]) m_active.push_back(slice);
    findBorder();
    return resting;
}

template<class Real>
void ActiveSlices<Real>::follow(const State& before, const State& state, double timeStep) {
    SliceList reached;
    for (const std::uint32_t slice : m_border) {
        if (!moves(slice, before, state, timeStep)) continue;
        forNeighbours(slice, [&](std::uint32_t neighbour) {
            if (!std::exchange(m_isActive[neighbour], 1)) reached.push_back(neighbour);
        });
    }
    if (reached.empty()) return;
    std::sort(reached.begin(), reached.end());
    const auto middle = m_active.insert(m_active.end(), reached.begin(), reached.end());
    std::inplace_merge(m_active.begin(), middle, m_active.end());
    m_border.insert(m_border.end(), reached.begin(), reached.end());
}

template class ActiveSlices<float>;
template class ActiveSlices<double>;

} // namespace esm
