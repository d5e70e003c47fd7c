// Layers of networks. Sums stay in registers: a block of columns is added up completely before the
// next one begins. Included by kernels.cpp alone.
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
        const float* row = weights + static_cast<std::ptrdiff_t>(rows[i]) * stride;
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

// The same where rows are given by bits.
template <int kVecs>
inline void sum_bits_columns(const float* base, const float* weights, const std::uint64_t* words,
                             int n_words, int width, float* out) {
    Vec sum[kVecs];
    for (int v = 0; v < kVecs; ++v) sum[v] = load<Vec>(base + v * kLanes);
    for (int w = 0; w < n_words; ++w, weights += static_cast<std::ptrdiff_t>(width) * 64) {
        for (std::uint64_t bits = words[w]; bits; bits &= bits - 1) {
            const float* row = weights + static_cast<std::ptrdiff_t>(lowest_bit(bits)) * width;
            for (int v = 0; v < kVecs; ++v) sum[v] += load<Vec>(row + v * kLanes);
        }
    }
    for (int v = 0; v < kVecs; ++v) store(out + v * kLanes, sum[v]);
}

void sum_bits(const float* base, const float* weights, const std::uint64_t* words, int n_words,
              int width, float* out) {
    int c = 0;
    for (; c + 2 * kPad <= width; c += 2 * kPad) {
        sum_bits_columns<2 * kPad / kLanes>(base + c, weights + c, words, n_words, width, out + c);
    }
    if (c < width) {
        sum_bits_columns<kPad / kLanes>(base + c, weights + c, words, n_words, width, out + c);
    }
}

// A row of weights that changes no sum: x + -0.0 = x for every x, which does not hold for +0.0.
struct Nothing {
    constexpr Nothing() {
        for (float& number : row) number = -0.0f;
    }
    alignas(4 * kPad) float row[4 * kPad]{};
};
constexpr Nothing kNothing;

// The same where the rows are the cells of the seen agents, bit by bit from the lowest. How many
// these are differs from view to view, so a loop's end is predicted badly: kMost rows are added
// without a branch, and where there are fewer, the row that changes nothing.
template <int kVecs, int kWords>
inline void sum_seen_columns(const Seen<kWords>& seen, const std::int32_t* cells, const float* base,
                             const float* weights, int width, Activation activation, float* out) {
    constexpr int kMost = 3;
    const auto nothing = reinterpret_cast<std::uintptr_t>(kNothing.row);
    const auto row_of = [&](std::uint64_t bits) {
        const int agent = lowest_bit(bits | std::uint64_t{1} << 63);
        return weights + static_cast<std::ptrdiff_t>(cells[agent] - seen.corner) * width;
    };
    Vec sum[kVecs];
    for (int v = 0; v < kVecs; ++v) sum[v] = load<Vec>(base + v * kLanes);
    for (int i = 0; i < kWords; ++i, cells += kPositionPad) {
        std::uint64_t bits = seen.words[i];
        for (int k = 0; k < kMost; ++k, bits &= bits - 1) {
            const std::uintptr_t mask = opaque(std::uintptr_t{0} - (bits != 0));
            const auto seen_row = reinterpret_cast<std::uintptr_t>(row_of(bits));
            const auto* row =
                reinterpret_cast<const float*>(nothing + ((seen_row - nothing) & mask));
            for (int v = 0; v < kVecs; ++v) sum[v] += load<Vec>(row + v * kLanes);
        }
        for (; bits; bits &= bits - 1) {
            const float* row = row_of(bits);
            for (int v = 0; v < kVecs; ++v) sum[v] += load<Vec>(row + v * kLanes);
        }
    }
    for (int v = 0; v < kVecs; ++v) store(out + v * kLanes, activate(sum[v], activation));
}

// A width that is known to the compiler, or 0, and the words of a view.
template <int kWidth, int kWords>
void sum_all_seen(const Positions positions, const int* agents, int n, const float* const* bases,
                  const float* weights, int any_width, Activation activation, float* out) {
    // As many columns at once as sums fit the registers.
    constexpr int kWide = kWidth == 0 && kLanes > 4 ? 4 * kPad : 2 * kPad;
    const int width = kWidth ? kWidth : any_width;
    // All agents look before the first sum: each step of either loop then waits for little.
    Seen<kWords> seen[kMaxPositions];
    for (int i = 0; i < n; ++i) {
        seen[i] = look<kWords>(positions, agents[i], positions.fov);
        // Duplicates are possible only among agents on shared cells; most views hold none.
        std::uint64_t shared = 0;
        for (int w = 0; w < kWords; ++w) shared |= seen[i].words[w] & positions.shared[w];
        if (shared) seen[i] = without_duplicates(positions, seen[i]);
    }
    for (int i = 0; i < n; ++i, out += width) {
        int c = 0;
        for (; c + kWide <= width; c += kWide) {
            sum_seen_columns<kWide / kLanes>(seen[i], positions.cells, bases[i] + c, weights + c,
                                             width, activation, out + c);
        }
        for (; c < width; c += kPad) {
            sum_seen_columns<kPad / kLanes>(seen[i], positions.cells, bases[i] + c, weights + c,
                                            width, activation, out + c);
        }
    }
}

void sum_seen(const Positions& positions, const int* agents, int n, const float* const* bases,
              const float* weights, int width, Activation activation, float* out) {
    constexpr int kUsual = 2 * kPad;
    constexpr int kMost = kMaxPositions / kPositionPad;
    const bool few = positions.n_agents <= kPositionPad;
    const auto usual = few ? sum_all_seen<kUsual, 1> : sum_all_seen<kUsual, kMost>;
    const auto any = few ? sum_all_seen<0, 1> : sum_all_seen<0, kMost>;
    (width == kUsual ? usual : any)(positions, agents, n, bases, weights, width, activation, out);
}

// sum[i][v] += in[i, :] weights, for kRows inputs and kVecs vectors of outputs. Each weight that is
// loaded serves kRows inputs, and the sums do not wait for each other.
template <typename V, int kRows, int kVecs>
inline void add_products(const float* in, int in_stride, int n_in, const float* weights, int width,
                         V (&sum)[kRows][kVecs]) {
    for (int k = 0; k < n_in; ++k) {
        V row[kVecs];
        for (int v = 0; v < kVecs; ++v) {
            row[v] = load<V>(weights + static_cast<std::ptrdiff_t>(k) * width + v * kLanesOf<V>);
        }
        for (int i = 0; i < kRows; ++i) {
            const V x = splat<V>(in[static_cast<std::ptrdiff_t>(i) * in_stride + k]);
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
            row[v] =
                widened(load<Vec>(weights + static_cast<std::ptrdiff_t>(k) * width + v * kLanes));
        }
        for (int i = 0; i < kRows; ++i) {
            const double x = in[static_cast<std::ptrdiff_t>(i) * in_stride + k];
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
        sure &= add_products_in_doubles<kFew>(in + static_cast<std::ptrdiff_t>(i) * in_stride,
                                              in_stride, n_in, weights, width, sum + i, end + i);
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
            store(out + static_cast<std::ptrdiff_t>(i) * width + v * kStep,
                  activate(sum[i][v], activation));
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
        rows(in + static_cast<std::ptrdiff_t>(i) * in_stride, in_stride, n_in, weights, bias, width,
             n_out, activation, out + static_cast<std::ptrdiff_t>(i) * width);
    }
}

}  // namespace

}  // namespace matrixworld
