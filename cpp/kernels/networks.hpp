// Layers of networks, and the sampling of actions. Sums stay in registers: a block of columns is
// added up completely before the next one begins. Included by kernels.cpp alone.
#pragma once

#include "kernels/look.hpp"

namespace matrixworld {

namespace {

// A block of kVecs vectors of the sum; the compiler unrolls the loops over v.
template <int kVecs>
inline void sum_columns(const float* base, const float* weights, int stride, const int* rows, int n,
                        Activation activation, float* out) {
    Vec sum[kVecs];
    for (int v = 0; v < kVecs; ++v) sum[v] = load<Vec>(base + v * kLanes);
    for (int i = 0; i < n; ++i) {
        const float* row = weights + static_cast<long>(rows[i]) * stride;
        for (int v = 0; v < kVecs; ++v) sum[v] += load<Vec>(row + v * kLanes);
    }
    for (int v = 0; v < kVecs; ++v) store(out + v * kLanes, activate(sum[v], activation));
}

void sum_rows(const float* base, const float* weights, int stride, const int* rows, int n,
              int width, Activation activation, float* out) {
    int c = 0;
    for (; c + 2 * kPad <= width; c += 2 * kPad) {
        sum_columns<2 * kPad / kLanes>(base + c, weights + c, stride, rows, n, activation, out + c);
    }
    if (c < width) {
        sum_columns<kPad / kLanes>(base + c, weights + c, stride, rows, n, activation, out + c);
    }
}

// The same where the rows are the cells of the seen agents, bit by bit from the lowest.
template <int kVecs>
inline void sum_seen_columns(const Seen& seen, const std::int32_t* cells, const float* base,
                             const float* weights, int width, Activation activation, float* out) {
    Vec sum[kVecs];
    for (int v = 0; v < kVecs; ++v) sum[v] = load<Vec>(base + v * kLanes);
    for (int i = 0; i < seen.n_words; ++i, cells += kPositionPad) {
        for (std::uint64_t bits = seen.words[i]; bits; bits &= bits - 1) {
            const int cell = cells[__builtin_ctzll(bits)] - seen.corner;
            const float* row = weights + static_cast<long>(cell) * width;
            for (int v = 0; v < kVecs; ++v) sum[v] += load<Vec>(row + v * kLanes);
        }
    }
    for (int v = 0; v < kVecs; ++v) store(out + v * kLanes, activate(sum[v], activation));
}

void sum_seen(const Positions& positions, const int* agents, int n, const float* const* bases,
              const float* weights, int width, Activation activation, float* out) {
    constexpr int kWide = 2 * kPad;
    for (int i = 0; i < n; ++i, out += width) {
        Seen seen = look(positions, agents[i], positions.fov);
        // Duplicates are possible only among agents on shared cells; most views hold none.
        std::uint64_t shared = 0;
        for (int w = 0; w < seen.n_words; ++w) shared |= seen.words[w] & positions.shared[w];
        if (shared) drop_duplicates(positions, seen);
        int c = 0;
        for (; c + kWide <= width; c += kWide) {
            sum_seen_columns<kWide / kLanes>(seen, positions.cells, bases[i] + c, weights + c,
                                             width, activation, out + c);
        }
        if (c < width) {
            sum_seen_columns<kPad / kLanes>(seen, positions.cells, bases[i] + c, weights + c, width,
                                            activation, out + c);
        }
    }
}

// sum[i][v] += in[i, :] weights, for kRows inputs and kVecs vectors of outputs. Each weight that is
// loaded serves kRows inputs, and the sums do not wait for each other.
template <typename V, int kRows, int kVecs>
inline void add_products(const float* in, int in_stride, int n_in, const float* weights, int width,
                         V (&sum)[kRows][kVecs]) {
    for (int k = 0; k < n_in; ++k) {
        V row[kVecs];
        for (int v = 0; v < kVecs; ++v) {
            row[v] = load<V>(weights + static_cast<long>(k) * width + v * kLanesOf<V>);
        }
        for (int i = 0; i < kRows; ++i) {
            const V x = splat<V>(in[static_cast<long>(i) * in_stride + k]);
            for (int v = 0; v < kVecs; ++v) sum[i][v] = madd(x, row[v], sum[i][v]);
        }
    }
}

#if !defined(MATRIXWORLD_FUSED)
// The same by doubles, in the registers for kRows inputs: the sums are right, and true is returned,
// unless one of them may have been rounded twice.
template <int kRows, int kVecs>
inline bool add_products_in_doubles(const float* in, int in_stride, int n_in, const float* weights,
                                    int width, const Vec (*start)[kVecs], Vec (*end)[kVecs]) {
    Wide sum[kRows][kVecs];
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) sum[i][v] = widened(start[i][v]);
    }
    Doubt doubt;
    for (int k = 0; k < n_in; ++k) {
        Wide row[kVecs];
        for (int v = 0; v < kVecs; ++v) {
            row[v] = widened(load<Vec>(weights + static_cast<long>(k) * width + v * kLanes));
        }
        for (int i = 0; i < kRows; ++i) {
            const double x = in[static_cast<long>(i) * in_stride + k];
            for (int v = 0; v < kVecs; ++v) add_product(sum[i][v], x, row[v], doubt);
        }
    }
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) end[i][v] = narrowed(sum[i][v]);
    }
    return !doubt.any();
}

template <int kRows, int kVecs>
inline void add_products(const float* in, int in_stride, int n_in, const float* weights, int width,
                         Vec (&sum)[kRows][kVecs]) {
    constexpr int kFew = 2;  // rows whose sums fit the registers
    Vec end[kRows][kVecs];
    bool sure = true;
    for (int i = 0; i < kRows; i += kFew) {
        sure &= add_products_in_doubles<kFew>(in + static_cast<long>(i) * in_stride, in_stride,
                                              n_in, weights, width, sum + i, end + i);
    }
    if (!sure) return add_products<Vec, kRows, kVecs>(in, in_stride, n_in, weights, width, sum);
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) sum[i][v] = end[i][v];
    }
}
#endif

// A tile of kRows inputs by kVecs vectors of outputs.
template <typename V, int kRows, int kVecs>
inline void dense_tile(const float* in, int in_stride, int n_in, const float* weights,
                       const float* bias, int width, Activation activation, float* out) {
    constexpr int kStep = kLanesOf<V>;
    V sum[kRows][kVecs];
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) sum[i][v] = load<V>(bias + v * kStep);
    }
    add_products(in, in_stride, n_in, weights, width, sum);
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) {
            store(out + static_cast<long>(i) * width + v * kStep, activate(sum[i][v], activation));
        }
    }
}

template <int kRows>
inline void dense_rows(const float* in, int in_stride, int n_in, const float* weights,
                       const float* bias, int width, int n_out, Activation activation, float* out) {
    int column = 0;
    for (; column + kLanes < n_out; column += 2 * kLanes) {
        dense_tile<Vec, kRows, 2>(in, in_stride, n_in, weights + column, bias + column, width,
                                  activation, out + column);
    }
    if (column >= n_out) return;
    // The rest: half a vector where that is enough.
    const bool few = n_out - column <= kLanesOf<Half>;
    const auto tile = few ? dense_tile<Half, kRows, 1> : dense_tile<Vec, kRows, 1>;
    tile(in, in_stride, n_in, weights + column, bias + column, width, activation, out + column);
}

// Eight rows at a time, the last ones possibly four. Rows beyond n are computed and never read.
void dense(const float* in, int in_stride, int n, int n_in, const float* weights, const float* bias,
           int width, int n_out, Activation activation, float* out) {
    for (int i = 0; i < n; i += kRowPad) {
        const auto rows = n - i > kRowPad / 2 ? dense_rows<kRowPad> : dense_rows<kRowPad / 2>;
        rows(in + static_cast<long>(i) * in_stride, in_stride, n_in, weights, bias, width, n_out,
             activation, out + static_cast<long>(i) * width);
    }
}

constexpr int kMaxActions = 9;

// Samples an action for each lane's agent by inverting the distribution: the action is the number
// of cumulated weights that do not exceed unit * total. The largest logit is subtracted first, so
// that no exponential overflows.
template <typename V>
inline void sample_lanes(const float* logits, int stride, int n, int n_actions, const float* units,
                         std::uint8_t* actions) {
    constexpr int kN = kLanesOf<V>;
    float by_action[kMaxActions][kN];
    float by_lane[kN];
    for (int lane = 0; lane < kN; ++lane) {
        const int i = lane < n ? lane : n - 1;  // lanes beyond the last agent repeat it
        by_lane[lane] = units[i];
        for (int a = 0; a < n_actions; ++a) {
            by_action[a][lane] = logits[static_cast<long>(i) * stride + a];
        }
    }
    const V unit = load<V>(by_lane);
    V logit[kMaxActions];
    for (int a = 0; a < n_actions; ++a) logit[a] = load<V>(by_action[a]);
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
    for (int lane = 0; lane < kN && lane < n; ++lane) {
        actions[lane] = static_cast<std::uint8_t>(chosen[lane]);
    }
}

void sample(const float* logits, int stride, int n, int n_actions, const float* units,
            std::uint8_t* actions) {
    int i = 0;
    while (i < n) {
        const bool few = n - i <= kLanesOf<Half>;
        const auto lanes = few ? sample_lanes<Half> : sample_lanes<Vec>;
        lanes(logits + static_cast<long>(i) * stride, stride, n - i, n_actions, units + i,
              actions + i);
        i += few ? kLanesOf<Half> : kLanes;
    }
}

}  // namespace

}  // namespace matrixworld
