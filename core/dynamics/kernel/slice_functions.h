#pragma once

#include "core/dynamics/kernel/slice_kernel.h"

// The kernel, for the vectors (Simd) that the including source has chosen before. In an unnamed namespace, as
// they are.
namespace esm::kernel {
namespace {

template<class Real> using Vector = typename Simd<Real>::Vector;

template<class Real> struct Vectors3 { Vector<Real> x, y, z; };

template<class Real> struct Motion { Vectors3<Real> position, velocity; };

template<class Real> Vectors3<Real> difference(const Vectors3<Real>& a, const Vectors3<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template<class Real>
[[gnu::always_inline]] inline void addScaled(Vectors3<Real>& sum, Vector<Real> factor,
                                             const Vectors3<Real>& a) {
    sum.x = Simd<Real>::multiplyAdd(factor, a.x, sum.x);
    sum.y = Simd<Real>::multiplyAdd(factor, a.y, sum.y);
    sum.z = Simd<Real>::multiplyAdd(factor, a.z, sum.z);
}

/// Adds factor·a, and keeps what rounding takes from the sum.
template<class Real>
[[gnu::always_inline]] inline void addKeeping(Vectors3<Real>& sum, Vector<Real> factor,
                                              const Vectors3<Real>& a, Remainders<Real>& remainders,
                                              std::size_t row) {
    const auto add = [&](Vector<Real>& component, Vector<Real> part, Lane<Real>& remainder) {
        const Vector<Real> change =
            Simd<Real>::multiplyAdd(factor, part, Simd<Real>::load(remainder.of + row));
        const Vector<Real> result = component + change;
        Simd<Real>::store(change - (result - component), remainder.of + row);
        component = result;
    };
    add(sum.x, a.x, remainders.of[0]);
    add(sum.y, a.y, remainders.of[1]);
    add(sum.z, a.z, remainders.of[2]);
}

/// Rounded as the scalar forces and rest lengths are: a spring as long as at rest gives exactly no force.
template<class Real> Vector<Real> squaredLength(const Vectors3<Real>& a) {
    return a.x * a.x + a.y * a.y + a.z * a.z;
}

template<class Real> Vector<Real> dot(const Vectors3<Real>& a, const Vectors3<Real>& b) {
    return Simd<Real>::multiplyAdd(a.x, b.x, Simd<Real>::multiplyAdd(a.y, b.y, a.z * b.z));
}

/// `record(i)` is the record of the i-th of as many nodes as a vector holds.
template<class Real, class Record> [[gnu::always_inline]] inline Motion<Real> gather(const Record& record) {
    Motion<Real> motion;
    auto& [position, velocity] = motion;
    Simd<Real>::gather([&](std::size_t i) { return record(i).position; }, position.x, position.y, position.z);
    Simd<Real>::gather([&](std::size_t i) { return record(i).velocity; }, velocity.x, velocity.y, velocity.z);
    return motion;
}

template<class Real>
[[gnu::always_inline]] inline void scatter(const Motion<Real>& motion, NodeRecord<Real>* records) {
    const auto& [position, velocity] = motion;
    Simd<Real>::scatter(position.x, position.y, position.z,
                        [&](std::size_t i) { return records[i].position; });
    Simd<Real>::scatter(velocity.x, velocity.y, velocity.z,
                        [&](std::size_t i) { return records[i].velocity; });
}

/// Adds what springs do to their first nodes; `lanes` are the springs' parameters.
template<bool biphasic, bool axial, class Real>
[[gnu::always_inline]] inline void addSpringForces(const Motion<Real>& own, const Motion<Real>& neighbour,
                                                   const Lane<Real>* lanes, std::size_t row,
                                                   Vectors3<Real>& force) {
    using S = Simd<Real>;
    const auto parameter = [&](std::size_t place) { return S::load(lanes[place].of + row); };
    const Vectors3<Real> between = difference(neighbour.position, own.position);
    const Vectors3<Real> approach = difference(neighbour.velocity, own.velocity);
    const Vector<Real> square = squaredLength(between);
    const Vector<Real> restRatio = parameter(lane::restLength) / S::squareRoot(square);

    Vector<Real> along =
        S::subtractProduct(parameter(lane::springConstant), parameter(lane::springConstant), restRatio);
    if constexpr (biphasic)
        along = S::multiplyAdd(
            parameter(lane::stiffening),
            S::positivePart(S::subtractProduct(S::broadcast(1), parameter(lane::stretchLimit), restRatio)),
            along);
    if constexpr (axial)
        along = S::multiplyAdd(parameter(lane::viscosity), dot(between, approach) / square, along);
    else
        addScaled(force, parameter(lane::viscosity), approach);
    addScaled(force, S::whereAboveZero(square, along), between);
}

template<class Real>
[[gnu::always_inline]] inline void addTetherForces(const Motion<Real>& own, const Tethers<Real>& tethers,
                                                   std::size_t row, Vectors3<Real>& force) {
    using S = Simd<Real>;
    const Vectors3<Real> rest{S::load(tethers.restPosition[0].of + row),
                              S::load(tethers.restPosition[1].of + row),
                              S::load(tethers.restPosition[2].of + row)};
    const Vector<Real> none = S::broadcast(0);
    addScaled(force, S::load(tethers.springConstant.of + row), difference(rest, own.position));
    addScaled(force, none - S::load(tethers.viscosity.of + row), own.velocity);
}

/// Adds what hinges do to their nodes.
template<class Real>
[[gnu::always_inline]] inline void addHingeForces(const HingeSums<Real>& hinges, std::size_t slice,
                                                  std::size_t row, Vectors3<Real>& force) {
    using S = Simd<Real>;
    for (std::size_t column = hinges.starts[slice]; column < hinges.starts[slice + 1]; ++column) {
        const std::uint32_t* const places = hinges.places[column].of + row;
        Vectors3<Real> added;
        S::gather([&](std::size_t i) { return hinges.forces[places[i]].of; }, added.x, added.y, added.z);
        addScaled<Real>(force, S::broadcast(1), added);
    }
}

/// Asks the memory for what is needed a page further on: by itself a processor looks ahead within a page
/// only.
[[gnu::always_inline]] inline void fetchAhead(const Neighbours* neighbours, const void* lanes,
                                              std::size_t laneBytes) {
    constexpr std::size_t page = 4096, cacheLine = 64;
    const auto* const ahead = static_cast<const char*>(lanes) + page;
    for (std::size_t line = 0; line < laneBytes; line += cacheLine)
        __builtin_prefetch(ahead + line);
    __builtin_prefetch(reinterpret_cast<const char*>(neighbours) + page / 4);
}

template<bool biphasic, bool axial, class Real>
[[gnu::always_inline]] inline Vectors3<Real> forces(const Slices<Real>& slices, std::size_t slice,
                                                    std::size_t row, const Motion<Real>& own,
                                                    const NodeRecord<Real>* records) {
    const Vector<Real> none = Simd<Real>::broadcast(0);
    Vectors3<Real> force{none, none, none};
    const auto* const base = reinterpret_cast<const char*>(records);
    constexpr std::size_t laneCount = biphasic ? biphasicLanes : linearLanes;
    for (std::size_t column = slices.starts[slice]; column < slices.starts[slice + 1]; ++column) {
        const std::uint32_t* const offsets = slices.neighbours[column].offset + row;
        const Motion<Real> neighbour = gather<Real>([&](std::size_t i) -> const NodeRecord<Real>& {
            return *reinterpret_cast<const NodeRecord<Real>*>(base + offsets[i]);
        });
        const Lane<Real>* const lanes = slices.springs + column * laneCount;
        if (row == 0) fetchAhead(slices.neighbours + column, lanes, laneCount * sizeof(Lane<Real>));
        addSpringForces<biphasic, axial>(own, neighbour, lanes, row, force);
    }
    if (slices.tethers) addTetherForces(own, slices.tethers[slice], row, force);
    if (slices.hinges.places) addHingeForces(slices.hinges, slice, row, force);
    return force;
}

template<bool biphasic, bool axial, class Real>
[[gnu::always_inline]] inline Vectors3<Real> accelerations(const Slices<Real>& slices,
                                                           const Passage<Real>& passage, std::size_t slice,
                                                           std::size_t row, const Motion<Real>& own) {
    using S = Simd<Real>;
    const Vector<Real> inverseMass = S::load(slices.inverseMass[slice].of + row);
    const auto gravity = [&](std::size_t axis) {
        return S::whereAboveZero(inverseMass, S::broadcast(passage.gravity[axis]));
    };
    Vectors3<Real> acceleration{gravity(0), gravity(1), gravity(2)};
    addScaled(acceleration, inverseMass, forces<biphasic, axial>(slices, slice, row, own, passage.from));
    return acceleration;
}

enum class Result { Step, Rates };

template<Result result, bool biphasic, bool axial, class Real>
[[gnu::always_inline]] inline Motion<Real> computed(const Slices<Real>& slices, const Passage<Real>& passage,
                                                    std::size_t slice, std::size_t row,
                                                    const Motion<Real>& own) {
    const Vectors3<Real> acceleration = accelerations<biphasic, axial>(slices, passage, slice, row, own);
    if constexpr (result == Result::Rates) return {own.velocity, acceleration};
    const Vector<Real> timeStep = Simd<Real>::broadcast(passage.timeStep);
    Motion<Real> next = own;
    addScaled(next.velocity, timeStep, acceleration);
    if (passage.remainders)
        addKeeping(next.position, timeStep, next.velocity, passage.remainders[slice], row);
    else
        addScaled(next.position, timeStep, next.velocity);
    return next;
}

/// Computes as many rows at once as a vector holds.
template<Result result, bool biphasic, bool axial, class Real>
void compute(const Slices<Real>& slices, const Passage<Real>& passage, SliceRange range) {
    for (std::size_t i = range.first; i < range.last; ++i) {
        const std::size_t slice = range.list ? range.list[i] : i;
        for (std::size_t row = 0; row < sliceHeight; row += Simd<Real>::width) {
            const std::size_t place = slice * sliceHeight + row;
            const NodeRecord<Real>* const records = passage.from + place;
            const Motion<Real> own =
                gather<Real>([&](std::size_t k) -> const NodeRecord<Real>& { return records[k]; });
            scatter(computed<result, biphasic, axial>(slices, passage, slice, row, own), passage.to + place);
        }
    }
}

template<Result result, class Real> constexpr void setFunctions(SliceFunction<Real> (&functions)[2][2]) {
    functions[0][0] = compute<result, false, false, Real>;
    functions[0][1] = compute<result, false, true, Real>;
    functions[1][0] = compute<result, true, false, Real>;
    functions[1][1] = compute<result, true, true, Real>;
}

} // namespace
} // namespace esm::kernel
