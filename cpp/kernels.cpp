// One level of the kernels: this file is compiled several times, with MATRIXWORLD_LEVEL naming the
// function that returns them. It includes nothing with inline code of its own: such code, compiled
// here for a newer processor, could be linked into the rest of the program.
#include "kernels.hpp"

#if defined(__FMA__) || defined(__AVX512F__)
#include <immintrin.h>
#endif

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
typedef float Unaligned __attribute__((vector_size(4 * kLanes), aligned(4), may_alias));
typedef std::uint32_t Bits __attribute__((vector_size(4 * kLanes)));
typedef std::int32_t Mask __attribute__((vector_size(4 * kLanes)));

inline Vec load(const float* at) { return *reinterpret_cast<const Unaligned*>(at); }
inline void store(float* at, Vec value) { *reinterpret_cast<Unaligned*>(at) = value; }
inline Vec splat(float value) { return value - Vec{}; }
inline Vec larger(Vec a, Vec b) { return a > b ? a : b; }

// a * b + c, rounded once.
inline Vec madd(Vec a, Vec b, Vec c) {
#if defined(__AVX512F__)
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__)
    return _mm256_fmadd_ps(a, b, c);
#else
    Vec result;
    for (int i = 0; i < kLanes; ++i) result[i] = __builtin_fmaf(a[i], b[i], c[i]);
    return result;
#endif
}

// e^x for x <= 0, to about 1e-7 (coefficients of the Cephes library's expf); 0 below -87.
inline Vec exp_negative(Vec x) {
    const Vec shifter = splat(12582912.0f);  // 1.5 * 2^23: adding it rounds to an integer
    const Vec low = splat(-87.0f);
    const Mask tiny = x < low;
    x = larger(x, low);
    const Vec shifted = madd(x, splat(1.44269504f), shifter);
    const Vec n = shifted - shifter;
    Vec r = madd(n, splat(-0.693359375f), x);
    r = madd(n, splat(2.12194440e-4f), r);
    Vec p = splat(1.9875691500e-4f);
    p = madd(p, r, splat(1.3981999507e-3f));
    p = madd(p, r, splat(8.3334519073e-3f));
    p = madd(p, r, splat(4.1665795894e-2f));
    p = madd(p, r, splat(1.6666665459e-1f));
    p = madd(p, r, splat(5.0000001201e-1f));
    const Vec value = madd(p * r, r, r) + splat(1.0f);
    const Vec scaled = (Vec)((Bits)value + ((Bits)shifted << 23));
    return tiny ? Vec{} : scaled;
}

inline Vec tanh_of(Vec x) {
    const Bits sign = (Bits)x & 0x80000000u;
    const Vec magnitude = (Vec)((Bits)x ^ sign);
    const Vec t = exp_negative(magnitude * splat(-2.0f));
    const Vec value = (splat(1.0f) - t) / (splat(1.0f) + t);
    return (Vec)((Bits)value | sign);
}

inline Vec activate(Vec x, Activation activation) {
    switch (activation) {
        case Activation::None:
            return x;
        case Activation::Relu:
            return larger(x, Vec{});
        case Activation::Tanh:
            return tanh_of(x);
    }
    return x;
}

// kVecs vectors of the sum, in registers.
template <int kVecs>
inline void sum_columns(const float* base, const float* weights, int stride, const int* rows, int n,
                        Activation activation, float* out) {
    Vec sum[kVecs];
    for (int v = 0; v < kVecs; ++v) sum[v] = load(base + v * kLanes);
    for (int i = 0; i < n; ++i) {
        const float* row = weights + static_cast<long>(rows[i]) * stride;
        for (int v = 0; v < kVecs; ++v) sum[v] += load(row + v * kLanes);
    }
    for (int v = 0; v < kVecs; ++v) store(out + v * kLanes, activate(sum[v], activation));
}

// Which of 64 places lie in a window of `side` + 1 rows and columns from (top, left), as bits. One
// comparison finds both ends: above the window, the difference wraps to a large number.
inline std::uint64_t near_bits(const std::int16_t* rows, const std::int16_t* cols, short top,
                               short left, short side) {
    std::uint64_t bits = 0;
#if defined(__AVX512BW__)
    const auto within = [&](const std::int16_t* places, short from) {
        const __m512i offset =
            _mm512_sub_epi16(_mm512_loadu_si512(places), _mm512_set1_epi16(from));
        return std::uint64_t{_mm512_cmple_epu16_mask(offset, _mm512_set1_epi16(side))};
    };
    for (int i = 0; i < 64; i += 32) {
        bits |= (within(rows + i, top) & within(cols + i, left)) << i;
    }
#elif defined(__AVX2__)
    const auto within = [&](const std::int16_t* places, short from) {
        const __m256i offset = _mm256_sub_epi16(
            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(places)), _mm256_set1_epi16(from));
        return _mm256_cmpeq_epi16(_mm256_min_epu16(offset, _mm256_set1_epi16(side)), offset);
    };
    const auto both = [&](int i) {
        return _mm256_and_si256(within(rows + i, top), within(cols + i, left));
    };
    for (int i = 0; i < 64; i += 32) {
        const __m256i bytes =
            _mm256_permute4x64_epi64(_mm256_packs_epi16(both(i), both(i + 16)), 0b11011000);
        bits |= std::uint64_t{static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes))} << i;
    }
#else
    const auto within = [&](std::int16_t place, short from) {
        return static_cast<std::uint16_t>(place - from) <= static_cast<std::uint16_t>(side);
    };
    for (int i = 0; i < 64; ++i) {
        bits |= std::uint64_t{within(rows[i], top) && within(cols[i], left)} << i;
    }
#endif
    return bits;
}

int find_near(const std::int16_t* rows, const std::int16_t* cols, int n, int row, int col,
              int reach, int* found) {
    int count = 0;
    for (int first = 0; first < n; first += kPlacePad) {
        std::uint64_t bits =
            near_bits(rows + first, cols + first, static_cast<short>(row - reach),
                      static_cast<short>(col - reach), static_cast<short>(2 * reach));
        for (; bits; bits &= bits - 1) found[count++] = first + __builtin_ctzll(bits);
    }
    return count;
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

// A tile of kRows inputs by kVecs vectors of outputs, in registers.
template <int kRows, int kVecs>
inline void dense_tile(const float* in, int in_stride, int n_in, const float* weights,
                       const float* bias, int width, Activation activation, float* out) {
    Vec sum[kRows][kVecs];
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) sum[i][v] = load(bias + v * kLanes);
    }
    for (int k = 0; k < n_in; ++k) {
        Vec row[kVecs];
        for (int v = 0; v < kVecs; ++v)
            row[v] = load(weights + static_cast<long>(k) * width + v * kLanes);
        for (int i = 0; i < kRows; ++i) {
            const Vec x = splat(in[static_cast<long>(i) * in_stride + k]);
            for (int v = 0; v < kVecs; ++v) sum[i][v] = madd(x, row[v], sum[i][v]);
        }
    }
    for (int i = 0; i < kRows; ++i) {
        for (int v = 0; v < kVecs; ++v) {
            store(out + static_cast<long>(i) * width + v * kLanes, activate(sum[i][v], activation));
        }
    }
}

template <int kRows>
inline void dense_rows(const float* in, int in_stride, int n_in, const float* weights,
                       const float* bias, int width, int n_out, Activation activation, float* out) {
    int column = 0;
    for (; column + kLanes < n_out; column += 2 * kLanes) {
        dense_tile<kRows, 2>(in, in_stride, n_in, weights + column, bias + column, width,
                             activation, out + column);
    }
    if (column < n_out) {
        dense_tile<kRows, 1>(in, in_stride, n_in, weights + column, bias + column, width,
                             activation, out + column);
    }
}

void dense(const float* in, int in_stride, int n, int n_in, const float* weights, const float* bias,
           int width, int n_out, Activation activation, float* out) {
    int i = 0;
    const auto rest = [&](int rows) { return n - i >= rows; };
    const auto at = [&](const float* array, int stride) {
        return array + static_cast<long>(i) * stride;
    };
    const auto to = [&] { return out + static_cast<long>(i) * width; };
    for (; rest(8); i += 8) {
        dense_rows<8>(at(in, in_stride), in_stride, n_in, weights, bias, width, n_out, activation,
                      to());
    }
    if (rest(4)) {
        dense_rows<4>(at(in, in_stride), in_stride, n_in, weights, bias, width, n_out, activation,
                      to());
        i += 4;
    }
    for (; rest(1); ++i) {
        dense_rows<1>(at(in, in_stride), in_stride, n_in, weights, bias, width, n_out, activation,
                      to());
    }
}

constexpr int kMaxActions = 9;

// One agent a lane.
void sample(const float* logits, int stride, int n, int n_actions, const float* units,
            std::uint8_t* actions) {
    for (int first = 0; first < n; first += kLanes) {
        float by_action[kMaxActions][kLanes];
        float by_lane[kLanes];
        for (int lane = 0; lane < kLanes; ++lane) {
            const int i = first + lane < n ? first + lane : n - 1;
            by_lane[lane] = units[i];
            for (int a = 0; a < n_actions; ++a) {
                by_action[a][lane] = logits[static_cast<long>(i) * stride + a];
            }
        }
        const Vec unit = load(by_lane);
        Vec logit[kMaxActions];
        for (int a = 0; a < n_actions; ++a) logit[a] = load(by_action[a]);
        Vec most = logit[0];
        for (int a = 1; a < n_actions; ++a) most = larger(logit[a], most);
        Vec cumulated[kMaxActions];
        Vec total{};
        for (int a = 0; a < n_actions; ++a) {
            total += exp_negative(logit[a] - most);
            cumulated[a] = total;
        }
        const Vec threshold = unit * total;
        Mask chosen{};
        for (int a = 0; a + 1 < n_actions; ++a) chosen -= cumulated[a] <= threshold;
        for (int lane = 0; lane < kLanes && first + lane < n; ++lane) {
            actions[first + lane] = static_cast<std::uint8_t>(chosen[lane]);
        }
    }
}

}  // namespace

#define MATRIXWORLD_STRING(name) #name
#define MATRIXWORLD_NAME(name) MATRIXWORLD_STRING(name)

const Kernels& MATRIXWORLD_LEVEL() {
    static constexpr Kernels level{MATRIXWORLD_NAME(MATRIXWORLD_LEVEL), find_near, sum_rows, dense,
                                   sample};
    return level;
}

}  // namespace matrixworld
