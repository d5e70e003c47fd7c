// From the outputs of a network to actions: one vector lane for each agent. Included by kernels.cpp
// alone.
#pragma once

#include "kernels/networks.hpp"

namespace matrixworld {

namespace {

constexpr int kMaxActions = 9;

// An action for each lane, drawn from the softmax by inverting the distribution: the action is the
// number of cumulated weights that do not exceed unit * total. The largest logit is subtracted
// first, so that no exponential overflows.
template <typename V>
inline Mask<V> sampled(const V* logit, int n_actions, V unit) {
    V largest = logit[0];
    for (int a = 1; a < n_actions; ++a) largest = larger(logit[a], largest);
    V cumulated[kMaxActions];
    V total{};
    for (int a = 0; a < n_actions; ++a) {
        total += exp_negative(logit[a] - largest);
        cumulated[a] = total;
    }
    const V threshold = unit * total;
    // A comparison is -1 where it holds, so subtracting counts. The last action needs none.
    Mask<V> chosen{};
    for (int a = 0; a + 1 < n_actions; ++a) chosen -= cumulated[a] <= threshold;
    return chosen;
}

// The action with the largest output; the first of them if several are equal.
template <typename V>
inline Mask<V> best(const V* logit, int n_actions) {
    V largest = logit[0];
    Mask<V> chosen{};
    for (int a = 1; a < n_actions; ++a) {
        const Mask<V> is_larger = largest < logit[a];
        largest = where(is_larger, logit[a], largest);
        chosen = where(is_larger, Mask<V>{} + a, chosen);
    }
    return chosen;
}

// Without units the largest output is chosen.
template <typename V>
inline Mask<V> chosen(const V* logit, int n_actions, const float* units) {
    return units ? sampled(logit, n_actions, load<V>(units)) : best(logit, n_actions);
}

template <typename V>
inline void choose_lanes(const float* logits, int stride, int n, int n_actions, const float* units,
                         std::uint8_t* actions) {
    constexpr int kN = kLanesOf<V>;
    float by_action[kMaxActions][kN];
    float by_lane[kN];
    for (int lane = 0; lane < kN; ++lane) {
        const int i = lane < n ? lane : n - 1;  // lanes beyond the last agent repeat it
        by_lane[lane] = units ? units[i] : 0;
        for (int a = 0; a < n_actions; ++a) {
            by_action[a][lane] = logits[static_cast<std::ptrdiff_t>(i) * stride + a];
        }
    }
    V logit[kMaxActions];
    for (int a = 0; a < n_actions; ++a) logit[a] = load<V>(by_action[a]);
    const Mask<V> action = chosen(logit, n_actions, units ? by_lane : nullptr);
    for (int lane = 0; lane < kN && lane < n; ++lane) {
        actions[lane] = static_cast<std::uint8_t>(action[lane]);
    }
}

void choose(const float* logits, int stride, int n, int n_actions, const float* units,
            std::uint8_t* actions) {
    int i = 0;
    while (i < n) {
        const bool few = n - i <= kLanesOf<Half>;
        const auto lanes = few ? choose_lanes<Half> : choose_lanes<Vec>;
        lanes(logits + static_cast<std::ptrdiff_t>(i) * stride, stride, n - i, n_actions,
              units ? units + i : nullptr, actions + i);
        i += few ? kLanesOf<Half> : kLanes;
    }
}

// ---- The last layer and the choice at once ------------------------------------------------------

#if defined(MATRIXWORLD_FUSED)
// Interleave two vectors: a0 b0 a1 b1 ..., of their lower halves or of their upper halves.
#if defined(__AVX512F__)
inline Vec interleave_low(Vec a, Vec b) {
    const __m512i order = _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
    return _mm512_permutex2var_ps(a, order, b);
}
inline Vec interleave_high(Vec a, Vec b) {
    const __m512i order =
        _mm512_set_epi32(31, 15, 30, 14, 29, 13, 28, 12, 27, 11, 26, 10, 25, 9, 24, 8);
    return _mm512_permutex2var_ps(a, order, b);
}
#endif
#if defined(__AVX2__)
inline Half interleave_low(Half a, Half b) {
    return _mm256_permute2f128_ps(_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b), 0x20);
}
inline Half interleave_high(Half a, Half b) {
    return _mm256_permute2f128_ps(_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b), 0x31);
}
#else
inline Vec interleave_low(Vec a, Vec b) { return Vec{a[0], b[0], a[1], b[1]}; }
inline Vec interleave_high(Vec a, Vec b) { return Vec{a[2], b[2], a[3], b[3]}; }
#endif

// Loads a square of as many agents by as many numbers as V has lanes, as one vector for each number.
// Interleaving the upper half of the rows with the lower half, log2(kN) times, transposes a square.
template <typename V>
inline void load_columns(const float* in, int stride, V* columns) {
    constexpr int kN = kLanesOf<V>;
    V rows[kN];
    for (int i = 0; i < kN; ++i) rows[i] = load<V>(in + static_cast<std::ptrdiff_t>(i) * stride);
    for (int n = kN; n > 1; n /= 2) {
        for (int i = 0; i < kN / 2; ++i) {
            columns[2 * i] = interleave_low(rows[i], rows[i + kN / 2]);
            columns[2 * i + 1] = interleave_high(rows[i], rows[i + kN / 2]);
        }
        for (int i = 0; i < kN; ++i) rows[i] = columns[i];
    }
}

// The outputs of as many agents as V has lanes, one vector for each action. Each agent's products
// are added in the order in which `dense` adds them.
template <typename V, int kActions>
inline void outputs(const float* in, int in_stride, int n_in, const float* weights,
                    const float* bias, int width, V* logit) {
    constexpr int kN = kLanesOf<V>;
    V sum[kActions];
    for (int a = 0; a < kActions; ++a) sum[a] = splat<V>(bias[a]);
    for (int k = 0; k < n_in; k += kN) {
        V columns[kN];
        load_columns(in + k, in_stride, columns);
        const int end = n_in - k < kN ? n_in - k : kN;
        for (int j = 0; j < end; ++j, weights += width) {
            for (int a = 0; a < kActions; ++a) {
                sum[a] = madd(columns[j], splat<V>(weights[a]), sum[a]);
            }
        }
    }
    for (int a = 0; a < kActions; ++a) logit[a] = sum[a];
}

template <typename V, int kActions>
inline void finish_lanes(const float* in, int in_stride, int n_in, const float* weights,
                         const float* bias, int width, const float* units, std::uint8_t* actions) {
    using Bytes = Lanes<std::uint8_t, kLanesOf<V>>;
    V logit[kMaxActions];
    outputs<V, kActions>(in, in_stride, n_in, weights, bias, width, logit);
    const Bytes bytes = converted<Bytes>(chosen(logit, kActions, units));
    std::memcpy(actions, &bytes, sizeof(bytes));
}

// The last agents take half a vector where that is enough.
template <int kActions>
inline void finish_all(const float* in, int in_stride, int n, int n_in, const float* weights,
                       const float* bias, int width, const float* units, std::uint8_t* actions) {
    for (int i = 0; i < n; i += kLanes) {
        const bool few = n - i <= kLanesOf<Half>;
        const auto lanes = few ? finish_lanes<Half, kActions> : finish_lanes<Vec, kActions>;
        lanes(in + static_cast<std::ptrdiff_t>(i) * in_stride, in_stride, n_in, weights, bias,
              width, units ? units + i : nullptr, actions + i);
    }
}

void finish(const float* in, int in_stride, int n, int n_in, const float* weights,
            const float* bias, int width, int n_actions, const float* units,
            std::uint8_t* actions) {
    const auto all = n_actions == 5 ? finish_all<5> : finish_all<kMaxActions>;
    all(in, in_stride, n, n_in, weights, bias, width, units, actions);
}
#else
// Without an instruction for the products `dense` is faster, which adds them in doubles.
void finish(const float* in, int in_stride, int n, int n_in, const float* weights,
            const float* bias, int width, int n_actions, const float* units,
            std::uint8_t* actions) {
    float logits[kRowPad * kPad];
    for (int i = 0; i < n; i += kRowPad) {
        const int rows = n - i < kRowPad ? n - i : kRowPad;
        dense(in + static_cast<std::ptrdiff_t>(i) * in_stride, in_stride, rows, n_in, weights, bias,
              width, n_actions, Activation::None, logits);
        choose(logits, width, rows, n_actions, units ? units + i : nullptr, actions + i);
    }
}
#endif

}  // namespace

}  // namespace matrixworld
