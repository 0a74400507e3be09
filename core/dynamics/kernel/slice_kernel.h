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

/// The tissue. Slice s has the columns starts[s] to starts[s+1]; a column is one Neighbours and the lanes of
/// its springs.
template<class Real> struct Slices {
    const std::uint32_t* starts;
    const Neighbours* neighbours;
    const Lane<Real>* springs;
    const Lane<Real>* inverseMass; ///< 1/kg; 0 in fixed rows
    const Tethers<Real>* tethers;  ///< per slice; null when there are none
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

/// By law (0 linear, 1 biphasic) and damping (0 isotropic, 1 axial).
template<class Real> struct SliceFunctions {
    SliceFunction<Real> step[2][2];  ///< semi-implicit Euler
    SliceFunction<Real> rates[2][2]; ///< `to` becomes the change with time
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
