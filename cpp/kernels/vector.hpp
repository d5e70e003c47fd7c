// Vectors of floats, and the functions of networks on them. Included by kernels.cpp alone, once for
// each instruction set; all that it defines stays in the file that includes it.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "kernels/kernels.hpp"

namespace matrixworld {

namespace {

#if defined(__AVX512F__)
constexpr int kLanes = 16;
#elif defined(__AVX2__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif

typedef float Vec __attribute__((vector_size(4 * kLanes)));
// For few outputs, or few agents: where vectors are wide, half of one.
typedef float Half __attribute__((vector_size(kLanes > 8 ? 32 : 4 * kLanes)));

template <typename V>
constexpr int kLanesOf = sizeof(V) / sizeof(float);
// The integers of the same size, as which comparisons come out.
template <typename V>
using Mask = decltype(V{} < V{});

template <typename V>
inline V load(const float* at) {
    V value;
    __builtin_memcpy(&value, at, sizeof(V));
    return value;
}
template <typename V>
inline void store(float* at, V value) {
    __builtin_memcpy(at, &value, sizeof(V));
}
template <typename V>
inline V splat(float value) {
    return value - V{};
}
template <typename V>
inline V larger(V a, V b) {
    return a > b ? a : b;
}

// a * b + c, rounded once.
#if defined(__AVX512F__)
inline Vec madd(Vec a, Vec b, Vec c) { return _mm512_fmadd_ps(a, b, c); }
inline Half madd(Half a, Half b, Half c) { return _mm256_fmadd_ps(a, b, c); }
#elif defined(__FMA__)
inline Vec madd(Vec a, Vec b, Vec c) { return _mm256_fmadd_ps(a, b, c); }
#else
inline Vec madd(Vec a, Vec b, Vec c) {
    Vec result;
    for (int i = 0; i < kLanes; ++i) result[i] = __builtin_fmaf(a[i], b[i], c[i]);
    return result;
}
#endif

// e^x for x <= 0, to about 1e-7 (coefficients of the Cephes library's expf); 0 below -87.
template <typename V>
inline V exp_negative(V x) {
    const auto number = [](float value) { return splat<V>(value); };
    const V shifter = number(12582912.0f);  // 1.5 * 2^23: adding it rounds to an integer
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
    const V scaled = (V)((Mask<V>)value + ((Mask<V>)shifted << 23));
    return tiny ? V{} : scaled;
}

template <typename V>
inline V tanh_of(V x) {
    const Mask<V> sign = (Mask<V>)x & static_cast<std::int32_t>(0x80000000u);
    const V magnitude = (V)((Mask<V>)x ^ sign);
    const V t = exp_negative(magnitude * splat<V>(-2.0f));
    const V value = (splat<V>(1.0f) - t) / (splat<V>(1.0f) + t);
    return (V)((Mask<V>)value | sign);
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
