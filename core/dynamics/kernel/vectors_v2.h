#pragma once

#include "core/dynamics/kernel/slice_kernel.h"

#include <immintrin.h>

// Vectors of x86-64-v2. In an unnamed namespace: each source that includes this is compiled for a processor
// of its own.
namespace esm::kernel {
namespace {

template<class Real> struct Simd;

template<> struct Simd<float> {
    using Vector = __m128;
    static constexpr std::size_t width = 4;

    static Vector broadcast(float value) { return _mm_set1_ps(value); }
    static Vector load(const float* from) { return _mm_load_ps(from); }
    static void store(Vector a, float* to) { _mm_store_ps(to, a); }
    static Vector multiplyAdd(Vector a, Vector b, Vector c) { return a * b + c; }
    static Vector subtractProduct(Vector c, Vector a, Vector b) { return c - a * b; }
    static Vector squareRoot(Vector a) { return _mm_sqrt_ps(a); }
    static Vector positivePart(Vector a) { return _mm_max_ps(a, _mm_setzero_ps()); }
    static Vector whereAboveZero(Vector condition, Vector a) {
        return _mm_and_ps(_mm_cmpgt_ps(condition, _mm_setzero_ps()), a);
    }

    /// x, y and z of the vectors that start at four places.
    template<class Place> static void gather(const Place& place, Vector& x, Vector& y, Vector& z) {
        const Vector a = _mm_load_ps(place(0)), b = _mm_load_ps(place(1));
        const Vector c = _mm_load_ps(place(2)), d = _mm_load_ps(place(3));
        const Vector xyLow = _mm_unpacklo_ps(a, b), xyHigh = _mm_unpacklo_ps(c, d);
        x = _mm_movelh_ps(xyLow, xyHigh);
        y = _mm_movehl_ps(xyHigh, xyLow);
        z = _mm_movelh_ps(_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d));
    }

    template<class Place> static void scatter(Vector x, Vector y, Vector z, const Place& place) {
        const Vector zero = _mm_setzero_ps();
        const Vector xyLow = _mm_unpacklo_ps(x, y), xyHigh = _mm_unpackhi_ps(x, y);
        const Vector zLow = _mm_unpacklo_ps(z, zero), zHigh = _mm_unpackhi_ps(z, zero);
        _mm_store_ps(place(0), _mm_movelh_ps(xyLow, zLow));
        _mm_store_ps(place(1), _mm_movehl_ps(zLow, xyLow));
        _mm_store_ps(place(2), _mm_movelh_ps(xyHigh, zHigh));
        _mm_store_ps(place(3), _mm_movehl_ps(zHigh, xyHigh));
    }
};

template<> struct Simd<double> {
    using Vector = __m128d;
    static constexpr std::size_t width = 2;

    static Vector broadcast(double value) { return _mm_set1_pd(value); }
    static Vector load(const double* from) { return _mm_load_pd(from); }
    static void store(Vector a, double* to) { _mm_store_pd(to, a); }
    static Vector multiplyAdd(Vector a, Vector b, Vector c) { return a * b + c; }
    static Vector subtractProduct(Vector c, Vector a, Vector b) { return c - a * b; }
    static Vector squareRoot(Vector a) { return _mm_sqrt_pd(a); }
    static Vector positivePart(Vector a) { return _mm_max_pd(a, _mm_setzero_pd()); }
    static Vector whereAboveZero(Vector condition, Vector a) {
        return _mm_and_pd(_mm_cmpgt_pd(condition, _mm_setzero_pd()), a);
    }

    template<class Place> static void gather(const Place& place, Vector& x, Vector& y, Vector& z) {
        const Vector a = _mm_load_pd(place(0)), b = _mm_load_pd(place(1));
        x = _mm_unpacklo_pd(a, b);
        y = _mm_unpackhi_pd(a, b);
        z = _mm_unpacklo_pd(_mm_load_pd(place(0) + 2), _mm_load_pd(place(1) + 2));
    }

    template<class Place> static void scatter(Vector x, Vector y, Vector z, const Place& place) {
        const Vector zero = _mm_setzero_pd();
        _mm_store_pd(place(0), _mm_unpacklo_pd(x, y));
        _mm_store_pd(place(0) + 2, _mm_unpacklo_pd(z, zero));
        _mm_store_pd(place(1), _mm_unpackhi_pd(x, y));
        _mm_store_pd(place(1) + 2, _mm_unpackhi_pd(z, zero));
    }
};

} // namespace
} // namespace esm::kernel
