// Vectors of floats and the activation functions on them: one source for all instruction sets. Included
// by kernels.cpp alone.
#pragma once

#include <cstddef>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "grid/compiler.hpp"
#include "kernels/kernels.hpp"
#include "kernels/multiply_add.hpp"

namespace matrixworld {

namespace {

#if !defined(MATRIXWORLD_PLAIN) && \
    (defined(__FMA__) || defined(__FP_FAST_FMAF) || defined(__aarch64__))
#define MATRIXWORLD_FUSED  // there is an instruction for a * b + c, rounded once
#endif

#if defined(MATRIXWORLD_FUSED) && defined(__AVX512F__)
constexpr int kLanes = 16;
#elif defined(MATRIXWORLD_FUSED) && defined(__AVX2__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif

using Vec = Lanes<float, kLanes>;
// Half of the widest vector: for a layer with few outputs (the actions), or few agents, where a
// whole one would mostly compute padding.
using Half = Lanes<float, (kLanes > 8 ? 8 : kLanes)>;

template <typename V>
constexpr int kLanesOf = sizeof(V) / sizeof(float);

// A memcpy of this size is one unaligned load or store.
template <typename V>
inline V load(const float* at) {
    V value;
    std::memcpy(&value, at, sizeof(V));
    return value;
}
template <typename V>
inline void store(float* at, V value) {
    std::memcpy(at, &value, sizeof(V));
}
template <typename V>
inline V larger(V a, V b) {
    return where(a > b, a, b);
}

// a * b + c, rounded once ("multiply-add"). Without an instruction (old x86 processors, WebAssembly),
// the same bits by way of doubles.
#if defined(MATRIXWORLD_FUSED) && defined(__AVX512F__)
inline Vec madd(Vec a, Vec b, Vec c) { return _mm512_fmadd_ps(a, b, c); }
inline Half madd(Half a, Half b, Half c) { return _mm256_fmadd_ps(a, b, c); }
#elif defined(MATRIXWORLD_FUSED) && defined(__AVX2__)
inline Vec madd(Vec a, Vec b, Vec c) { return _mm256_fmadd_ps(a, b, c); }
#elif defined(MATRIXWORLD_FUSED)
inline Vec madd(Vec a, Vec b, Vec c) {
    Vec result;
    for (int i = 0; i < kLanes; ++i) result[i] = fused(a[i], b[i], c[i]);
    return result;
}
#else
inline Vec madd(Vec a, Vec b, Vec c) { return multiply_add(a, b, c); }
#endif

// e^x for x <= 0, to about 1e-7; 0 below -87, where e^x leaves the range of normal floats.
//
// x = n ln 2 + r with an integer n, so e^x = 2^n e^r with |r| <= ln(2) / 2, and e^r is a polynomial
// (coefficients of the Cephes library's expf). ln 2 is subtracted in two parts, since one float
// would lose digits of r.
template <typename V>
inline V exp_negative(V x) {
    const auto number = [](float value) { return splat<V>(value); };
    // 1.5 * 2^23: adding it rounds to an integer and leaves that integer in the lowest bits.
    const V shifter = number(12582912.0f);
    const V low = number(-87.0f);
    const Mask<V> tiny = x < low;
    x = larger(x, low);
    const V shifted = madd(x, number(1.44269504f), shifter);
    const V n = shifted - shifter;
    V r = madd(n, number(-0.693359375f), x);
    r = madd(n, number(2.12194440e-4f), r);
    V p = number(1.9875691500e-4f);
    p = madd(p, r, number(1.3981999507e-3f));
    p = madd(p, r, number(8.3334519073e-3f));
    p = madd(p, r, number(4.1665795894e-2f));
    p = madd(p, r, number(1.6666665459e-1f));
    p = madd(p, r, number(5.0000001201e-1f));
    const V value = madd(p * r, r, r) + number(1.0f);
    // 2^n: n is added to the exponent's bits.
    const V scaled = as<V>(as<Mask<V>>(value) + (as<Mask<V>>(shifted) << 23));
    return where(tiny, V{}, scaled);
}

// tanh |x| = (1 - e^(-2|x|)) / (1 + e^(-2|x|)), whose exponential never overflows; then the sign of
// x.
template <typename V>
inline V tanh_of(V x) {
    const Mask<V> sign = as<Mask<V>>(x) & static_cast<std::int32_t>(0x80000000u);
    const V magnitude = as<V>(as<Mask<V>>(x) ^ sign);
    const V t = exp_negative(magnitude * splat<V>(-2.0f));
    const V value = (splat<V>(1.0f) - t) / (splat<V>(1.0f) + t);
    return as<V>(as<Mask<V>>(value) | sign);
}

template <typename V>
inline V activate(V x, Activation activation) {
    switch (activation) {
        case Activation::None:
            return x;
        case Activation::Relu:
            return larger(x, V{});
        case Activation::Tanh:
            return tanh_of(x);
    }
    return x;
}

}  // namespace

}  // namespace matrixworld
