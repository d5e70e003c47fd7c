// Who sees whom. Included by kernels.cpp alone, like kernel_vector.hpp.
#pragma once

#include "kernels/vector.hpp"

namespace matrixworld {

namespace {

// Which of n places, at most 64, lie in a window of `side` + 1 rows and columns from (top, left), as
// bits. One comparison finds both ends: above the window, the difference wraps to a large number.
inline std::uint64_t near_bits(const std::int16_t* rows, const std::int16_t* cols, int n, short top,
                               short left, short side) {
    std::uint64_t bits = 0;
#if defined(__AVX512BW__)
    const auto within = [&](const std::int16_t* places, short from) {
        const __m512i offset =
            _mm512_sub_epi16(_mm512_loadu_si512(places), _mm512_set1_epi16(from));
        return std::uint64_t{_mm512_cmple_epu16_mask(offset, _mm512_set1_epi16(side))};
    };
    for (int i = 0; i < n; i += 32) {
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
    for (int i = 0; i < n; i += 32) {
        const __m256i bytes =
            _mm256_permute4x64_epi64(_mm256_packs_epi16(both(i), both(i + 16)), 0b11011000);
        bits |= std::uint64_t{static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes))} << i;
    }
#elif defined(__SSE2__)
    const auto at = [](const std::int16_t* places) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(places));
    };
    const auto beyond = [&](const std::int16_t* places, short from) {  // 0 where within
        return _mm_subs_epu16(_mm_sub_epi16(at(places), _mm_set1_epi16(from)),
                              _mm_set1_epi16(side));
    };
    const auto both = [&](int i) {
        return _mm_cmpeq_epi16(_mm_or_si128(beyond(rows + i, top), beyond(cols + i, left)),
                               _mm_setzero_si128());
    };
    for (int i = 0; i < n; i += 16) {
        const int mask = _mm_movemask_epi8(_mm_packs_epi16(both(i), both(i + 8)));
        bits |= std::uint64_t{static_cast<std::uint32_t>(mask)} << i;
    }
#else
    const auto within = [&](std::int16_t place, short from) {
        return static_cast<std::uint16_t>(place - from) <= static_cast<std::uint16_t>(side);
    };
    for (int i = 0; i < n; ++i) {
        bits |= std::uint64_t{within(rows[i], top) && within(cols[i], left)} << i;
    }
#endif
    return bits;
}

// Which agents another one sees, as bits.
struct Seen {
    static constexpr int kWords = kMaxPositions / kPositionPad;

    std::uint64_t words[kWords];
    int n_words;
    int corner;  // what to subtract from the cells of those seen
};

// Of those seen who set the same cell, leaves the first.
inline void drop_doubles(const Positions& positions, Seen& seen) {
    int first[kMaxPositions];  // of those on shared cells, on each
    int n = 0;
    for (int i = 0; i < seen.n_words; ++i) {
        for (std::uint64_t bits = seen.words[i] & positions.shared[i]; bits; bits &= bits - 1) {
            const int agent = i * kPositionPad + __builtin_ctzll(bits);
            bool known = false;
            for (int k = 0; k < n; ++k)
                known |= positions.cells[first[k]] == positions.cells[agent];
            first[n] = agent;
            n += !known;
            seen.words[i] &= ~(std::uint64_t{known} << (agent % kPositionPad));
        }
    }
}

inline int most(int n) { return n < kPositionPad ? n : kPositionPad; }

inline Seen look(const Positions& positions, int agent, int fov) {
    const int reach = fov / 2;
    const short top = static_cast<short>(positions.rows[agent] - reach);
    const short left = static_cast<short>(positions.cols[agent] - reach);
    Seen seen;
    seen.n_words = (positions.n_agents + kPositionPad - 1) / kPositionPad;
    seen.corner = top * fov + left;
    for (int i = 0; i < seen.n_words; ++i) {
        const int first = i * kPositionPad;
        const std::uint64_t self = std::uint64_t{agent / kPositionPad == i}
                                   << (agent % kPositionPad);
        seen.words[i] =
            near_bits(positions.rows + first, positions.cols + first,
                      most(positions.n_agents - first), top, left, static_cast<short>(2 * reach)) &
            ~self;
    }
    return seen;
}

}  // namespace

}  // namespace matrixworld
