#pragma once

#include "core/dynamics/kernel/slice_functions.h"

// What hinges do, for the vectors (Simd) that the including source has chosen before: the formulas of
// core/dynamics/hinge_force.h.
namespace esm::kernel {
namespace {

template<class Real> Vectors3<Real> scaled(Vector<Real> factor, const Vectors3<Real>& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}

template<class Real> Vectors3<Real> crossProduct(const Vectors3<Real>& a, const Vectors3<Real>& b) {
    using S = Simd<Real>;
    return {S::subtractProduct(a.y * b.z, a.z, b.y), S::subtractProduct(a.z * b.x, a.x, b.z),
            S::subtractProduct(a.x * b.y, a.y, b.x)};
}

/// As many hinges as a vector holds.
template<class Real> struct HingeLanes {
    const HingeNodes& nodes;
    const Lane<Real>* lanes;
    std::size_t row;

    Vector<Real> parameter(std::size_t place) const { return Simd<Real>::load(lanes[place].of + row); }

    Motion<Real> motionOf(std::size_t corner, const NodeRecord<Real>* records) const {
        const auto* const base = reinterpret_cast<const char*>(records);
        const std::uint32_t* const offsets = nodes.offset[corner] + row;
        return gather<Real>([&](std::size_t i) -> const NodeRecord<Real>& {
            return *reinterpret_cast<const NodeRecord<Real>*>(base + offsets[i]);
        });
    }

    /// Σ w·a, of what three nodes have beside the first.
    Vectors3<Real> weighted(const Vectors3<Real>& second, const Vectors3<Real>& third,
                            const Vectors3<Real>& fourth) const {
        Vectors3<Real> sum = scaled<Real>(parameter(hinge_lane::weight), second);
        addScaled<Real>(sum, parameter(hinge_lane::weight + 1), third);
        addScaled<Real>(sum, parameter(hinge_lane::weight + 2), fourth);
        return sum;
    }
};

template<class Real>
void scatterForce(const Vectors3<Real>& force, HingeForce<Real>* forces, std::size_t corner) {
    Simd<Real>::scatter(force.x, force.y, force.z, [&](std::size_t i) { return forces[4 * i + corner].of; });
}

/// @param forces of the first of these hinges and those that follow
template<class Real>
[[gnu::always_inline]] inline void computeHinges(const HingeLanes<Real>& hinges,
                                                 const NodeRecord<Real>* records, HingeForce<Real>* forces) {
    using S = Simd<Real>;
    const Motion<Real> first = hinges.motionOf(0, records), second = hinges.motionOf(1, records);
    const Motion<Real> third = hinges.motionOf(2, records), fourth = hinges.motionOf(3, records);
    const Vector<Real> none = S::broadcast(0);
    const Vector<Real> curvature = hinges.parameter(hinge_lane::restCurvature);

    const Vectors3<Real> edge = difference<Real>(second.position, first.position);
    const Vectors3<Real> across = difference<Real>(fourth.position, third.position);
    Vectors3<Real> strain = hinges.weighted(edge, difference<Real>(third.position, first.position),
                                            difference<Real>(fourth.position, first.position));
    addScaled<Real>(strain, none - curvature, crossProduct<Real>(edge, across));
    const Vectors3<Real> rate = hinges.weighted(difference<Real>(second.velocity, first.velocity),
                                                difference<Real>(third.velocity, first.velocity),
                                                difference<Real>(fourth.velocity, first.velocity));

    const Vectors3<Real> elastic = scaled<Real>(none - hinges.parameter(hinge_lane::springConstant), strain);
    const Vectors3<Real> turning = scaled<Real>(curvature, elastic);
    const Vectors3<Real> onEdge = crossProduct<Real>(turning, across);
    const Vectors3<Real> onAcross = crossProduct<Real>(edge, turning);
    Vectors3<Real> between = elastic;
    addScaled<Real>(between, none - hinges.parameter(hinge_lane::viscosity), rate);

    const Vector<Real> one = S::broadcast(1);
    Vectors3<Real> onSecond = scaled<Real>(hinges.parameter(hinge_lane::weight), between);
    Vectors3<Real> onThird = scaled<Real>(hinges.parameter(hinge_lane::weight + 1), between);
    Vectors3<Real> onFourth = scaled<Real>(hinges.parameter(hinge_lane::weight + 2), between);
    addScaled<Real>(onSecond, one, onEdge);
    addScaled<Real>(onThird, none - one, onAcross);
    addScaled<Real>(onFourth, one, onAcross);
    const Vectors3<Real> onFirst{none - (onSecond.x + onThird.x + onFourth.x),
                                 none - (onSecond.y + onThird.y + onFourth.y),
                                 none - (onSecond.z + onThird.z + onFourth.z)};
    scatterForce<Real>(onFirst, forces, 0);
    scatterForce<Real>(onSecond, forces, 1);
    scatterForce<Real>(onThird, forces, 2);
    scatterForce<Real>(onFourth, forces, 3);
}

template<class Real>
void hingeForces(const HingeBlocks<Real>& blocks, const NodeRecord<Real>* records, std::size_t first,
                 std::size_t last) {
    for (std::size_t block = first; block < last; ++block)
        for (std::size_t row = 0; row < sliceHeight; row += Simd<Real>::width)
            computeHinges<Real>({blocks.nodes[block], blocks.lanes + block * hingeLanes, row}, records,
                                blocks.forces + 4 * (block * sliceHeight + row));
}

template<class Real> constexpr SliceFunctions<Real> sliceFunctions() {
    SliceFunctions<Real> functions{};
    setFunctions<Result::Step>(functions.step);
    setFunctions<Result::Rates>(functions.rates);
    functions.hingeForces = hingeForces<Real>;
    return functions;
}

} // namespace
} // namespace esm::kernel
