#pragma once

#include "core/dynamics/kernel/tissue_kernel.h"

namespace esm {

/// Which of a kernel's slices move, so that only they are computed: those with a node that still has a way to
/// go, and the slices around them. With the velocity v and acceleration a of a node, its way to go is
/// |v|·(wave time + drift time) + |a|·(wave time)², of its Settling.
template<class Real> class ActiveSlices {
public:
    using State = typename TissueKernel<Real>::State;
    using SliceList = typename TissueKernel<Real>::SliceList;

    /// @param tolerance m, that the motion may differ by from that of the whole tissue; 0, and of
    /// tissue that has hinges: every slice is active for ever
    ActiveSlices(const SpringSystem& system, const TissueKernel<Real>& kernel, double tolerance);

    bool areAll() const { return m_active.size() == m_isActive.size(); }
    bool contains(std::size_t slice) const { return m_isActive[slice] != 0; }
    const SliceList& list() const { return m_active; } ///< ascending
    double fraction() const;

    void activateAll();
    /// Leaves those active that move, `timeStep` (s) after `before`, and the slices around them. Returns what
    /// came to rest.
    SliceList release(const State& before, const State& state, double timeStep);
    /// Where motion has reached the border of what is active, it goes on into the slices beyond.
    void follow(const State& before, const State& state, double timeStep);

private:
    /// What turns velocity and acceleration into a way to go; 0 for fixed nodes.
    struct Slowness {
        Real perVelocity;     ///< s
        Real perAcceleration; ///< s²
    };

    bool moves(std::size_t slice, const State& before, const State& state, double timeStep) const;
    void findBorder();
    template<class Visit> void forNeighbours(std::size_t slice, const Visit& visit) const;

    Real m_leastWay;                                   ///< m, of what moves; 0: nothing rests
    std::vector<Slowness> m_slowness;                  ///< per row
    std::vector<std::uint32_t> m_starts, m_neighbours; ///< of each slice, its neighbours
    std::vector<char> m_isActive;
    SliceList m_active, m_border; ///< the latter are active and have a neighbour that is not
};

extern template class ActiveSlices<float>;
extern template class ActiveSlices<double>;

} // namespace esm
