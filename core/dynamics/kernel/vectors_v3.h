#pragma once

#include "core/dynamics/kernel/slice_kernel.h"

#include <immintrin.h>

// Vectors of x86-64-v3. In an unnamed namespace: each source that includes this is compiled for a processor
// of its own.
namespace esm::kernel {
namespace {

template<class Real> struct Simd;

template<> struct Simd<float> {
    using Vector = __m256;
    static constexpr std::size_t width = 8;

    static Vector broadcast(float value) { return _mm256_set1_ps(value); }
    static Vector load(const float* from) { return _mm256_load_ps(from); }
    static void store(Vector a, float* to) { _mm256_store_ps(to, a); }
    static Vector multiplyAdd(Vector a, Vector b, Vector c) { return _mm256_fmadd_ps(a, b, c); }
    static Vector subtractProduct(Vector c, Vector a, Vector b) { return _mm256_fnmadd_ps(a, b, c); }
    static Vector squareRoot(Vector a) { return _mm256_sqrt_ps(a); }
    static Vector positivePart(Vector a) { return _mm256_max_ps(a, _mm256_setzero_ps()); }
    static Vector whereAboveZero(Vector condition, Vector a) {
        return _mm256_and_ps(_mm256_cmp_ps(condition, _mm256_setzero_ps(), _CMP_GT_OQ), a);
    }

    /// x, y and z of the vectors that start at eight places.
    template<class Place> static void gather(const Place& place, Vector& x, Vector& y, Vector& z) {
        const Vector a = loadTwo(place(0), place(4)), b = loadTwo(place(1), place(5));
        const Vector c = loadTwo(place(2), place(6)), d = loadTwo(place(3), place(7));
        const Vector xyLow = _mm256_unpacklo_ps(a, b), xyHigh = _mm256_unpacklo_ps(c, d);
        x = joinLow(xyLow, xyHigh);
        y = joinHigh(xyLow, xyHigh);
        z = joinLow(_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d));
    }

    template<class Place> static void scatter(Vector x, Vector y, Vector z, const Place& place) {
        const Vector zero = _mm256_setzero_ps();
        const Vector xyLow = _mm256_unpacklo_ps(x, y), xyHigh = _mm256_unpackhi_ps(x, y);
        const Vector zLow = _mm256_unpacklo_ps(z, zero), zHigh = _mm256_unpackhi_ps(z, zero);
        storeTwo(joinLow(xyLow, zLow), place(0), place(4));
        storeTwo(joinHigh(xyLow, zLow), place(1), place(5));
        storeTwo(joinLow(xyHigh, zHigh), place(2), place(6));
        storeTwo(joinHigh(xyHigh, zHigh), place(3), place(7));
    }

private:
    static Vector loadTwo(const float* low, const float* high) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(low)), _mm_load_ps(high), 1);
    }
    static void storeTwo(Vector a, float* low, float* high) {
        _mm_store_ps(low, _mm256_castps256_ps128(a));
        _mm_store_ps(high, _mm256_extractf128_ps(a, 1));
    }
    static Vector joinLow(Vector a, Vector b) {
        return _mm256_castpd_ps(_mm256_unpacklo_pd(_mm256_castps_pd(a), _mm256_castps_pd(b)));
    }
    static Vector joinHigh(Vector a, Vector b) {
        return _mm256_castpd_ps(_mm256_unpackhi_pd(_mm256_castps_pd(a), _mm256_castps_pd(b)));
    }
};

template<> struct Simd<double> {
    using Vector = __m256d;
    static constexpr std::size_t width = 4;

    static Vector broadcast(double value) { return _mm256_set1_pd(value); }
    static Vector load(const double* from) { return _mm256_load_pd(from); }
    static void store(Vector a, double* to) { _mm256_store_pd(to, a); }
    static Vector multiplyAdd(Vector a, Vector b, Vector c) { return _mm256_fmadd_pd(a, b, c); }
    static Vector subtractProduct(Vector c, Vector a, Vector b) { return _mm256_fnmadd_pd(a, b, c); }
    static Vector squareRoot(Vector a) { return _mm256_sqrt_pd(a); }
    static Vector positivePart(Vector a) { return _mm256_max_pd(a, _mm256_setzero_pd()); }
    static Vector whereAboveZero(Vector condition, Vector a) {
        return _mm256_and_pd(_mm256_cmp_pd(condition, _mm256_setzero_pd(), _CMP_GT_OQ), a);
    }

    template<class Place> static void gather(const Place& place, Vector& x, Vector& y, Vector& z) {
        const Vector a = loadTwo(place(0), place(2)), b = loadTwo(place(1), place(3));
        x = _mm256_unpacklo_pd(a, b);
        y = _mm256_unpackhi_pd(a, b);
        z = _mm256_unpacklo_pd(loadTwo(place(0) + 2, place(2) + 2), loadTwo(place(1) + 2, place(3) + 2));
    }

    template<class Place> static void scatter(Vector x, Vector y, Vector z, const Place& place) {
        const Vector zero = _mm256_setzero_pd();
        const Vector xyEven = _mm256_unpacklo_pd(x, y), xyOdd = _mm256_unpackhi_pd(x, y);
        const Vector zEven = _mm256_unpacklo_pd(z, zero), zOdd = _mm256_unpackhi_pd(z, zero);
        _mm256_store_pd(place(0), _mm256_permute2f128_pd(xyEven, zEven, 0x20));
        _mm256_store_pd(place(1), _mm256_permute2f128_pd(xyOdd, zOdd, 0x20));
        _mm256_store_pd(place(2), _mm256_permute2f128_pd(xyEven, zEven, 0x31));
        _mm256_store_pd(place(3), _mm256_permute2f128_pd(xyOdd, zOdd, 0x31));
    }

private:
    static Vector loadTwo(const double* low, const double* high) {
        return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low)), _mm_load_pd(high), 1);
    }
};

} // namespace
} // namespace esm::kernel
