#pragma once

#include "core/dynamics/kernel/hinge_layout.h"
#include "core/dynamics/kernel/slice_layout.h"
#include "core/dynamics/kernel/thread_team.h"
#include "core/dynamics/settings.h"

namespace esm {

/// Where the kernel's vector instructions are from: x86-64-v2 (SSE 4.2), or also AVX2 and FMA of x86-64-v3.
enum class InstructionSet { V2, V3 };
InstructionSet bestInstructionSet(); ///< of this processor

struct KernelOptions {
    Damping damping = Damping::Isotropic;
    std::optional<InstructionSet> instructionSet{}; ///< the best without; this processor must have it
    ThreadTeam* team = nullptr;                     ///< outlives the kernel; none is one thread
    std::size_t threads = 0;                        ///< at most; 0: as many as the size is worth
};

/// Forces and explicit steps of a tissue, at the speed of the machine. Nodes lie in an order of the kernel's
/// own (rows), in slices of kernel::sliceHeight that can be computed by themselves. Every node sums up its
/// springs and hinges in a fixed order: results do not depend on the number of threads.
template<class Real> class TissueKernel {
public:
    /// One record per row, those behind the last node 0.
    using State = LargeVector<kernel::NodeRecord<Real>>;
    using SliceList = std::vector<std::uint32_t>;
    /// What rounding took from the positions of a state that moves on, per slice; 0 at first.
    using Remainders = LargeVector<kernel::Remainders<Real>>;

    struct Step {
        double duration;                  ///< s
        Eigen::Vector3d gravity;          ///< m/s²
        Remainders* remainders = nullptr; ///< those of the state; none: what rounding takes is lost
    };

    /// @throws InvalidModel when there are too many nodes
    TissueKernel(const SpringSystem& system, const KernelOptions& options);

    /// Takes new parameters, tethers and fixed nodes. Precondition: springs and hinges join the same nodes as
    /// before.
    void setParameters(const SpringSystem& system);

    std::size_t nodeCount() const { return m_layout.rowOfNode.size(); }
    std::size_t sliceCount() const { return m_layout.sliceCount(); }
    std::size_t rowOf(std::size_t node) const { return m_layout.rowOfNode[node]; }
    std::size_t sliceOf(std::size_t node) const { return rowOf(node) / kernel::sliceHeight; }
    /// 1/kg; 0 when the node is fixed. With it the caller adds to a step what acts on single nodes.
    Real inverseMass(std::size_t node) const;

    State load(const Vectors& positions, const Vectors& velocities) const;
    void store(const State& state, Vectors& positions, Vectors& velocities) const;

    /// One step of semi-implicit Euler: v⁺ = v + h·a(x, v), x⁺ = x + h·v⁺. Fixed nodes keep their velocity.
    /// `to` is another state than `from`; with a list, only its slices are written.
    void step(const State& from, State& to, const Step& step) const;
    void step(const State& from, State& to, const Step& step, const SliceList& slices) const;

    /// Changes with time: `rates` has velocities for positions and accelerations for velocities.
    void rates(const State& state, const Eigen::Vector3d& gravity, State& rates) const;
    void rates(const State& state, const Eigen::Vector3d& gravity, State& rates,
               const SliceList& slices) const;

private:
    using Function = kernel::SliceFunction<Real>;

    void setSprings(const SpringSystem& system);
    void setHinges(const SpringSystem& system);
    void setMasses(const SpringSystem& system);
    void setTethers(const SpringSystem& system);
    void partition();
    std::size_t threadsFor(std::size_t columns) const;
    void computeHinges(const State& from) const;
    kernel::Slices<Real> slices() const;
    void runAll(Function function, const kernel::Passage<Real>& passage) const;
    void runList(Function function, const kernel::Passage<Real>& passage, const SliceList& list) const;

    Damping m_damping;
    ThreadTeam* m_team;
    std::size_t m_mostThreads;
    const kernel::SliceFunctions<Real>* m_functions;

    SliceLayout m_layout;
    HingeLayout m_hingeLayout;
    bool m_isBiphasic = false;
    LargeVector<kernel::Lane<Real>> m_springs, m_hinges, m_inverseMass;
    LargeVector<kernel::Tethers<Real>> m_tethers;
    mutable LargeVector<kernel::HingeForce<Real>> m_hingeForces; ///< of the step that is computed
    std::vector<std::size_t> m_parts; ///< first slice of each part that threads share out, and the end
};

extern template class TissueKernel<float>;
extern template class TissueKernel<double>;

} // namespace esm
