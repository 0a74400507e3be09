#include "core/dynamics/kernel/tissue_kernel.h"

#include <algorithm>
#include <cassert>

namespace esm {

namespace {

using kernel::sliceHeight;

/// Columns of eight springs below which another thread costs more than it gains: a few microseconds of waking
/// it and of waiting for it.
constexpr std::size_t fewestColumnsPerThread = 750;
/// More parts than threads even out what else the machine does.
constexpr std::size_t partsPerThread = 4;
/// What a slice costs beside its springs, in columns.
constexpr std::size_t columnsPerSlice = 2;
/// What eight hinges cost, in columns of eight springs.
constexpr std::size_t columnsPerHingeBlock = 4;

template<class Real> const kernel::SliceFunctions<Real>& functionsOf(InstructionSet set);
template<> const kernel::SliceFunctions<float>& functionsOf<float>(InstructionSet set) {
    return set == InstructionSet::V3 ? kernel::v3::floatFunctions : kernel::v2::floatFunctions;
}
template<> const kernel::SliceFunctions<double>& functionsOf<double>(InstructionSet set) {
    return set == InstructionSet::V3 ? kernel::v3::doubleFunctions : kernel::v2::doubleFunctions;
}

template<class Real>
kernel::Passage<Real> passage(const LargeVector<kernel::NodeRecord<Real>>& from,
                              LargeVector<kernel::NodeRecord<Real>>& to,
                              const typename TissueKernel<Real>::Step& step) {
    assert(from.size() == to.size() && &from != &to);
    assert(!step.remainders || step.remainders->size() * sliceHeight == from.size());
    const auto g = step.gravity.template cast<Real>().eval();
    auto* const remainders = step.remainders ? step.remainders->data() : nullptr;
    return {from.data(), to.data(), remainders, {g.x(), g.y(), g.z()}, static_cast<Real>(step.duration)};
}

} // namespace

InstructionSet bestInstructionSet() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? InstructionSet::V3
                                                                           : InstructionSet::V2;
}

// Every spring is computed twice, at each of its ends, and each node adds up its own. To compute it once and
// add its force to both ends would be half the arithmetic, but two threads, or two lanes of one vector, could
// then write to the same node, and sums would come in an order that depends on the threads. So nodes are only
// read, each is written by one lane, and the result is the same however many threads there are.
//
// Nodes are records of position and velocity together, eight numbers on one cache line in double: a spring
// needs all of them of its other end, at a place that cannot be foreseen, and meets one line instead of six.
template<class Real>
TissueKernel<Real>::TissueKernel(const SpringSystem& system, const KernelOptions& options)
    : m_damping(options.damping), m_team(options.team), m_mostThreads(options.threads),
      m_functions(&functionsOf<Real>(options.instructionSet.value_or(bestInstructionSet()))),
      m_layout(makeSliceLayout(system, sizeof(kernel::NodeRecord<Real>))),
      m_hingeLayout(makeHingeLayout(system, m_layout, sizeof(kernel::NodeRecord<Real>))) {
    setParameters(system);
    partition();
}

template<class Real> void TissueKernel<Real>::setParameters(const SpringSystem& system) {
    assert(system.mass.size() == nodeCount() && system.springs.size() == m_layout.entries.size() &&
           system.hinges.size() == m_hingeLayout.order.size());
    setSprings(system);
    setHinges(system);
    setMasses(system);
    setTethers(system);
}

// Each spring's numbers stand at both its entries, as it is computed at both. A tissue without a second phase
// anywhere has three lanes in place of five, and a function without that term.
template<class Real> void TissueKernel<Real>::setSprings(const SpringSystem& system) {
    m_isBiphasic = std::any_of(system.springs.begin(), system.springs.end(),
                               [](const auto& spring) { return !spring.secondPhase.isLinear(); });
    const std::size_t laneCount = m_isBiphasic ? kernel::biphasicLanes : kernel::linearLanes;
    m_springs.assign(m_layout.neighbours.size() * laneCount, kernel::Lane<Real>{});
    for (std::size_t i = 0; i < system.springs.size(); ++i) {
        const auto& spring = system.springs[i];
        const auto& [strain, stiffConstant] = spring.secondPhase;
        for (const std::size_t entry : {m_layout.entries[i].first, m_layout.entries[i].second}) {
            kernel::Lane<Real>* const lanes = &m_springs[entry / sliceHeight * laneCount];
            const auto set = [&](std::size_t lane, double value) {
                lanes[lane].of[entry % sliceHeight] = static_cast<Real>(value);
            };
            set(kernel::lane::restLength, spring.restLength);
            set(kernel::lane::springConstant, spring.springConstant);
            set(kernel::lane::viscosity, spring.viscosity);
            if (spring.secondPhase.isLinear()) continue;
            set(kernel::lane::stretchLimit, 1 + strain);
            set(kernel::lane::stiffening, stiffConstant - spring.springConstant);
        }
    }
}

template<class Real> void TissueKernel<Real>::setHinges(const SpringSystem& system) {
    m_hinges.assign(m_hingeLayout.blockCount() * kernel::hingeLanes, kernel::Lane<Real>{});
    m_hingeForces.assign(system.hinges.empty() ? 0 : m_hingeLayout.forceCount(), kernel::HingeForce<Real>{});
    for (std::size_t i = 0; i < system.hinges.size(); ++i) {
        const auto& hinge = system.hinges[m_hingeLayout.order[i]];
        kernel::Lane<Real>* const lanes = &m_hinges[i / sliceHeight * kernel::hingeLanes];
        const auto set = [&](std::size_t lane, double value) {
            lanes[lane].of[i % sliceHeight] = static_cast<Real>(value);
        };
        for (std::size_t corner = 1; corner < 4; ++corner)
            set(kernel::hinge_lane::weight + corner - 1, hinge.weights[corner]);
        set(kernel::hinge_lane::restCurvature, hinge.restCurvature);
        set(kernel::hinge_lane::springConstant, hinge.springConstant);
        set(kernel::hinge_lane::viscosity, hinge.viscosity);
    }
}

// The inverse is kept since a step multiplies by it, and because 0 then stands for what does not move: fixed
// nodes and rows behind the last node need no branch.
template<class Real> void TissueKernel<Real>::setMasses(const SpringSystem& system) {
    m_inverseMass.assign(sliceCount(), kernel::Lane<Real>{});
    for (std::size_t node = 0; node < nodeCount(); ++node)
        if (!system.fixed[node])
            m_inverseMass[sliceOf(node)].of[rowOf(node) % sliceHeight] =
                static_cast<Real>(1 / system.mass[node]);
}

// Tethers of one node rest at one place, so that their constants add up. Where there are any, each row has
// one, of constants 0 where its node has none: the kernel then needs no branch for a row.
template<class Real> void TissueKernel<Real>::setTethers(const SpringSystem& system) {
    m_tethers.assign(system.tethers.empty() ? 0 : sliceCount(), kernel::Tethers<Real>{});
    for (const Tether& tether : system.tethers) {
        kernel::Tethers<Real>& slice = m_tethers[sliceOf(tether.node)];
        const std::size_t row = rowOf(tether.node) % sliceHeight;
        slice.springConstant.of[row] += static_cast<Real>(tether.springConstant);
        slice.viscosity.of[row] += static_cast<Real>(tether.viscosity);
        const Eigen::Vector3d& rest = system.network->restPositions[tether.node];
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            slice.restPosition[axis].of[row] = static_cast<Real>(rest[axis]);
    }
}

template<class Real> Real TissueKernel<Real>::inverseMass(std::size_t node) const {
    return m_inverseMass[sliceOf(node)].of[rowOf(node) % sliceHeight];
}

template<class Real>
typename TissueKernel<Real>::State TissueKernel<Real>::load(const Vectors& positions,
                                                            const Vectors& velocities) const {
    State state(m_layout.rowCount());
    for (std::size_t node = 0; node < nodeCount(); ++node)
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            state[rowOf(node)].position[axis] = static_cast<Real>(positions[node][axis]);
            state[rowOf(node)].velocity[axis] = static_cast<Real>(velocities[node][axis]);
        }
    return state;
}

template<class Real>
void TissueKernel<Real>::store(const State& state, Vectors& positions, Vectors& velocities) const {
    positions.resize(nodeCount());
    velocities.resize(nodeCount());
    for (std::size_t node = 0; node < nodeCount(); ++node)
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            positions[node][axis] = static_cast<double>(state[rowOf(node)].position[axis]);
            velocities[node][axis] = static_cast<double>(state[rowOf(node)].velocity[axis]);
        }
}

template<class Real> void TissueKernel<Real>::step(const State& from, State& to, const Step& step) const {
    computeHinges(from);
    runAll(m_functions->step[m_isBiphasic][m_damping == Damping::Axial], passage<Real>(from, to, step));
}

template<class Real>
void TissueKernel<Real>::step(const State& from, State& to, const Step& step, const SliceList& slices) const {
    computeHinges(from);
    runList(m_functions->step[m_isBiphasic][m_damping == Damping::Axial], passage<Real>(from, to, step),
            slices);
}

template<class Real>
void TissueKernel<Real>::rates(const State& state, const Eigen::Vector3d& gravity, State& rates) const {
    computeHinges(state);
    runAll(m_functions->rates[m_isBiphasic][m_damping == Damping::Axial],
           passage<Real>(state, rates, {0, gravity}));
}

template<class Real>
void TissueKernel<Real>::rates(const State& state, const Eigen::Vector3d& gravity, State& rates,
                               const SliceList& slices) const {
    computeHinges(state);
    runList(m_functions->rates[m_isBiphasic][m_damping == Damping::Axial],
            passage<Real>(state, rates, {0, gravity}), slices);
}

template<class Real> std::size_t TissueKernel<Real>::threadsFor(std::size_t columns) const {
    if (!m_team) return 1;
    if (m_mostThreads > 0) return std::min(m_mostThreads, m_team->size());
    return std::clamp<std::size_t>(columns / fewestColumnsPerThread, 1, m_team->size());
}

/// Parts that cost about the same, by the columns they have, which differ from slice to slice. The parts are
/// made once: a thread then has the same slices in every step, whose data is in its cache still.
template<class Real> void TissueKernel<Real>::partition() {
    const auto cost = [this](std::size_t slice) { return m_layout.starts[slice] + columnsPerSlice * slice; };
    const std::size_t threads = threadsFor(m_layout.starts.back());
    const std::size_t parts = threads > 1 ? partsPerThread * threads : 1;
    m_parts = {0};
    for (std::size_t part = 1; part < parts; ++part) {
        const std::size_t wanted = cost(sliceCount()) * part / parts;
        std::size_t slice = m_parts.back();
        while (slice < sliceCount() && cost(slice) < wanted)
            ++slice;
        m_parts.push_back(slice);
    }
    m_parts.push_back(sliceCount());
}

template<class Real> kernel::Slices<Real> TissueKernel<Real>::slices() const {
    return {m_layout.starts.data(),
            m_layout.neighbours.data(),
            m_springs.data(),
            m_inverseMass.data(),
            m_tethers.empty() ? nullptr : m_tethers.data(),
            {m_hingeLayout.starts.data(), m_hingeForces.empty() ? nullptr : m_hingeLayout.places.data(),
             m_hingeForces.data()}};
}

/// Before slices sum up what hinges do to their nodes; of all hinges, whichever slices these are.
template<class Real> void TissueKernel<Real>::computeHinges(const State& from) const {
    if (m_hingeForces.empty()) return;
    const std::size_t count = m_hingeLayout.blockCount();
    const std::size_t threads = threadsFor(columnsPerHingeBlock * count);
    const std::size_t parts = threads > 1 ? partsPerThread * threads : 1;
    const kernel::HingeBlocks<Real> blocks{m_hingeLayout.nodes.data(), m_hinges.data(), m_hingeForces.data()};
    const auto compute = [&](std::size_t part) {
        m_functions->hingeForces(blocks, from.data(), count * part / parts, count * (part + 1) / parts);
    };
    if (parts == 1) return compute(0);
    m_team->run(parts, compute, threads);
}

template<class Real>
void TissueKernel<Real>::runAll(Function function, const kernel::Passage<Real>& passage) const {
    const kernel::Slices<Real> tissue = slices();
    const auto compute = [&](std::size_t part) {
        function(tissue, passage, {m_parts[part], m_parts[part + 1], nullptr});
    };
    if (m_parts.size() == 2) return compute(0);
    m_team->run(m_parts.size() - 1, compute, m_parts.size() / partsPerThread);
}

// A list of slices has no parts made beforehand. They are equally many slices, taken to cost as much as the
// mean of all.
template<class Real>
void TissueKernel<Real>::runList(Function function, const kernel::Passage<Real>& passage,
                                 const SliceList& list) const {
    const kernel::Slices<Real> tissue = slices();
    const std::size_t columns = m_layout.starts.back() * list.size() / std::max<std::size_t>(sliceCount(), 1);
    const std::size_t threads = threadsFor(columns);
    if (threads == 1) return function(tissue, passage, {0, list.size(), list.data()});
    const std::size_t parts = partsPerThread * threads;
    const auto compute = [&](std::size_t part) {
        function(tissue, passage,
                 {list.size() * part / parts, list.size() * (part + 1) / parts, list.data()});
    };
    m_team->run(parts, compute, threads);
}

template class TissueKernel<float>;
template class TissueKernel<double>;

} // namespace esm
