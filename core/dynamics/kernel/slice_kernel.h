#pragma once

#include <cstddef>
#include <cstdint>

// What the kernel's variants for different instruction sets are called with. They are compiled with options
// of their own: no inline function of a library may be included here, lest the linker keep the one that only
// newer processors can run.
namespace esm::kernel {

/// Nodes are computed in slices of this many rows, whose lists of springs are equally long.
inline constexpr std::size_t sliceHeight = 8;

/// What moves, of one node; or its change with time, velocity and acceleration.
template<class Real> struct alignas(8 * sizeof(Real)) NodeRecord {
    Real position[4]; ///< m; the last is 0
    Real velocity[4]; ///< m/s; the last is 0
};

/// One number for each row of a slice.
template<class Real> struct alignas(sliceHeight * sizeof(Real)) Lane { Real of[sliceHeight]; };

/// One spring of each row of a slice: the distance in bytes from the first node's record to the neighbour's.
/// A row with fewer springs than others is its own neighbour.
struct alignas(32) Neighbours {
    std::uint32_t offset[sliceHeight];
};

/// Places of a spring's parameters among its lanes. Linear springs have the first three.
namespace lane {
inline constexpr std::size_t restLength = 0, springConstant = 1, viscosity = 2;
inline constexpr std::size_t stretchLimit = 3; ///< length over rest length from where the spring is stiffer
inline constexpr std::size_t stiffening = 4;   ///< N/m, by which it is stiffer
} // namespace lane
inline constexpr std::size_t linearLanes = 3, biphasicLanes = 5;

template<class Real> struct Tethers {
    Lane<Real> springConstant, viscosity; ///< 0 in rows without
    Lane<Real> restPosition[3];
};

/// Hinges in blocks of as many as a slice has rows: of each of their nodes, the distance in bytes from the
/// first record. Those behind the last hinge have all parameters 0.
struct alignas(32) HingeNodes {
    std::uint32_t offset[4][sliceHeight];
};

/// Places of a hinge's parameters among the lanes of its block.
namespace hinge_lane {
inline constexpr std::size_t weight = 0; ///< of the second node, third and fourth; the first has what is left
inline constexpr std::size_t restCurvature = 3, springConstant = 4, viscosity = 5;
} // namespace hinge_lane
inline constexpr std::size_t hingeLanes = 6;

/// What a hinge does to one of its nodes, N; the last is 0.
template<class Real> struct alignas(4 * sizeof(Real)) HingeForce { Real of[4]; };

template<class Real> struct HingeBlocks {
    const HingeNodes* nodes;
    const Lane<Real>* lanes;
    HingeForce<Real>* forces; ///< four of each hinge
};

/// Where in a list of forces those on the rows of a slice are; rows with fewer than others point at none.
struct alignas(32) ForcePlaces {
    std::uint32_t of[sliceHeight];
};

/// The forces of hinges that each row sums up, in columns as springs are.
template<class Real> struct HingeSums {
    const std::uint32_t* starts;
    const ForcePlaces* places; ///< null when there are no hinges
    const HingeForce<Real>* forces;
};

/// The tissue. Slice s has the columns starts[s] to starts[s+1]; a column is one Neighbours and the lanes of
/// its springs.
template<class Real> struct Slices {
    const std::uint32_t* starts;
    const Neighbours* neighbours;
    const Lane<Real>* springs;
    const Lane<Real>* inverseMass; ///< 1/kg; 0 in fixed rows
    const Tethers<Real>* tethers;  ///< per slice; null when there are none
    HingeSums<Real> hinges;
};

/// What rounding took from the positions of a slice's nodes, m. Added to the next change, it is not lost
/// however many steps there are: Kahan's sum.
template<class Real> struct Remainders { Lane<Real> of[3]; };

/// Slices `first` to `last`, or what a list has there.
struct SliceRange {
    std::size_t first, last;
    const std::uint32_t* list; ///< may be null
};

template<class Real> struct Passage {
    const NodeRecord<Real>* from;
    NodeRecord<Real>* to;
    Remainders<Real>* remainders; ///< per slice; null: what rounding takes is lost
    Real gravity[3];              ///< m/s²
    Real timeStep;                ///< s
};

template<class Real> using SliceFunction = void (*)(const Slices<Real>&, const Passage<Real>&, SliceRange);

/// Computes the forces of the hinges of the blocks `first` to `last`.
template<class Real>
using HingeFunction = void (*)(const HingeBlocks<Real>&, const NodeRecord<Real>*, std::size_t first,
                               std::size_t last);

/// By law (0 linear, 1 biphasic) and damping (0 isotropic, 1 axial).
template<class Real> struct SliceFunctions {
    SliceFunction<Real> step[2][2];  ///< semi-implicit Euler
    SliceFunction<Real> rates[2][2]; ///< `to` becomes the change with time
    HingeFunction<Real> hingeForces;
};

namespace v2 {
extern const SliceFunctions<float> floatFunctions;
extern const SliceFunctions<double> doubleFunctions;
} // namespace v2

namespace v3 {
extern const SliceFunctions<float> floatFunctions;
extern const SliceFunctions<double> doubleFunctions;
} // namespace v3

} // namespace esm::kernel
