// The recurrent layer: what an agent remembers from step to step. Included by kernels.cpp alone.
#pragma once

#include "kernels/networks.hpp"

namespace matrixworld {

namespace {

// tanh(x / 2^kHalvings): y P(y^2) / Q(y^2) of that quotient y, fitted so that the largest error is as
// small as possible up to 8.7, and 1 beyond, with the sign of x. Off by at most 3.6e-7, as all floats were tried.
template <int kHalvings, typename V>
inline V saturating_tanh(V x) {
    constexpr float kScale = 1.0f / (1 << kHalvings);
    constexpr float s = kScale * kScale;  // powers of 2: the products with coefficients are exact
    const auto number = [](float value) { return splat<V>(value); };
    const V t = x * x;
    V p = number(kScale * s * s * s * s * 1.3727396e-08f);
    V q = number(s * s * s * s * 7.92404003e-07f);
    p = madd(p, t, number(kScale * s * s * s * 2.08612308e-05f));
    q = madd(q, t, number(s * s * s * 0.000331004639f));
    p = madd(p, t, number(kScale * s * s * 0.00351022165f));
    q = madd(q, t, number(s * s * 0.0259319499f));
    p = madd(p, t, number(kScale * s * 0.13393118f));
    q = madd(q, t, number(s * 0.467264243f));
    p = madd(p, t, number(kScale * 0.999999932f));
    q = madd(q, t, number(1.0f));
    const V end = where(x < V{}, number(-1.0f), number(1.0f));
    const V magnitude = as<V>(as<Mask<V>>(x) & 0x7fffffff);
    return where(magnitude < number(8.7f / kScale), x * p / q, end);
}

// 1 / (1 + e^-x) = 1/2 + tanh(x / 2) / 2, off by at most 2e-7.
template <typename V>
inline V logistic(V x) {
    const V half = splat<V>(0.5f);
    return madd(half, saturating_tanh<1>(x), half);
}

// The inputs and states of kRows agents, with the weights of both.
struct Recurrent {
    const float* in;
    int in_stride;
    const float* states;
    int width;  // floats of a row of states
    int n_units;
    const float* weights;
    int stride;  // floats of a row of weights

    template <typename V, int kRows, int kVecs>
    void add_inputs(int column, V (&sum)[kRows][kVecs]) const {
        add_products(in, in_stride, n_units, weights + column, stride, sum);
    }
    template <typename V, int kRows, int kVecs>
    void add_states(int column, V (&sum)[kRows][kVecs]) const {
        const float* rows = weights + static_cast<std::ptrdiff_t>(n_units) * stride;
        add_products(states, width, n_units, rows + column, stride, sum);
    }
};

// z h + (1 - z) tanh(b + x W + r (h U)), for a block of kPad units.
template <int kRows>
inline void gru_tile(const Recurrent& layer, const float* bias, int block, float* out) {
    constexpr int kVecs = kPad / kLanes;
    Vec sum[kRows][3 * kVecs];  // of the gates r and z, and of the candidate
    Vec from_input[kRows][kVecs];
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < 3 * kVecs; ++v) sum[i][v] = load<Vec>(bias + 3 * block + v * kLanes);
    }
    layer.add_inputs(3 * block, sum);
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) {
            from_input[i][v] = sum[i][2 * kVecs + v];
            sum[i][2 * kVecs + v] = Vec{};
        }
    }
    layer.add_states(3 * block, sum);
    // Gate by gate for all agents: the steps of one function wait for each other.
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < 2 * kVecs; ++v) sum[i][v] = logistic(sum[i][v]);
    }
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) {
            Vec& fresh = sum[i][2 * kVecs + v];
            fresh = saturating_tanh<0>(madd(sum[i][v], fresh, from_input[i][v]));
        }
    }
    for (int i = 0; i < kRows; ++i) {
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(i) * layer.width + block;
        for (int v = 0; v < kVecs; ++v) {
            const Vec fresh = sum[i][2 * kVecs + v];
            const Vec old = load<Vec>(layer.states + row + v * kLanes);
            store(out + row + v * kLanes, madd(sum[i][kVecs + v], old - fresh, fresh));
        }
    }
}

constexpr int kGruRows = kLanes == kPad ? 4 : 2;  // as many as sums fit the registers

void remember(const float* in, int in_stride, const float* states, int n, int n_units,
              const float* weights, const float* bias, float* out) {
    const int width = padded(n_units);
    Recurrent layer{in, in_stride, states, width, n_units, weights, kGates * width};
    for (int i = 0; i < n; i += kGruRows) {
        for (int c = 0; c < width; c += kPad) gru_tile<kGruRows>(layer, bias, c, out);
        layer.in += static_cast<std::ptrdiff_t>(kGruRows) * in_stride;
        layer.states += static_cast<std::ptrdiff_t>(kGruRows) * width;
        out += static_cast<std::ptrdiff_t>(kGruRows) * width;
    }
}

}  // namespace

}  // namespace matrixworld
