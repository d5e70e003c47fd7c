// Which agents see which: all positions are compared with the window of one agent, 64 at a time,
// and the answer is a word of bits. Included by kernels.cpp alone.
#pragma once

#include "kernels/vector.hpp"

namespace matrixworld {

namespace {

// Which of n positions lie in the window of `side` + 1 rows and columns from (top, left), as bits.
// Precondition: n <= 64. One unsigned comparison tests both ends: for a position before the window
// the difference wraps to a large number. Whole vectors are read; the arrays have room for it.
inline std::uint64_t near_bits(const std::int16_t* rows, const std::int16_t* cols, int n, short top,
                               short left, short side) {
    std::uint64_t bits = 0;
#if defined(__AVX512BW__)
    const auto within = [&](const std::int16_t* along, short from) {
        const __m512i offset = _mm512_sub_epi16(_mm512_loadu_si512(along), _mm512_set1_epi16(from));
        return std::uint64_t{_mm512_cmple_epu16_mask(offset, _mm512_set1_epi16(side))};
    };
    for (int i = 0; i < n; i += 32) {
        bits |= (within(rows + i, top) & within(cols + i, left)) << i;
    }
#elif defined(__AVX2__)
    const auto within = [&](const std::int16_t* along, short from) {
        const __m256i offset = _mm256_sub_epi16(
            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(along)), _mm256_set1_epi16(from));
        return _mm256_cmpeq_epi16(_mm256_min_epu16(offset, _mm256_set1_epi16(side)), offset);
    };
    const auto both = [&](int i) {
        return _mm256_and_si256(within(rows + i, top), within(cols + i, left));
    };
    for (int i = 0; i < n; i += 32) {
        // Packing interleaves the two halves of 128 bits; the permutation restores their order.
        const __m256i bytes =
            _mm256_permute4x64_epi64(_mm256_packs_epi16(both(i), both(i + 16)), 0b11011000);
        bits |= std::uint64_t{static_cast<std::uint32_t>(_mm256_movemask_epi8(bytes))} << i;
    }
#elif defined(__SSE2__)
    const auto at = [](const std::int16_t* along) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(along));
    };
    const auto beyond = [&](const std::int16_t* along, short from) {  // 0 where within
        return _mm_subs_epu16(_mm_sub_epi16(at(along), _mm_set1_epi16(from)), _mm_set1_epi16(side));
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
    const auto within = [&](std::int16_t at, short from) {
        return static_cast<std::uint16_t>(at - from) <= static_cast<std::uint16_t>(side);
    };
    for (int i = 0; i < n; ++i) {
        bits |= std::uint64_t{within(rows[i], top) && within(cols[i], left)} << i;
    }
#endif
    return bits;
}

// The agents that one agent sees, as bits.
template <int kWords>
struct Seen {
    std::uint64_t words[kWords];
    int corner;  // `Positions::cells` less this are indices into the view
};

inline int at_most_pad(int n) { return n < kPositionPad ? n : kPositionPad; }

// Precondition: at most kWords * kPositionPad agents. The compiler knows kWords, so the words stay in
// registers.
template <int kWords>
inline Seen<kWords> look(const Positions& positions, int agent, int fov) {
    const int reach = fov / 2;
    const short top = static_cast<short>(positions.rows[agent] - reach);
    const short left = static_cast<short>(positions.cols[agent] - reach);
    Seen<kWords> seen;
    seen.corner = top * fov + left;
    for (int i = 0; i < kWords; ++i) {
        const int first = i * kPositionPad;
        // An agent does not see itself.
        const std::uint64_t self = std::uint64_t{agent / kPositionPad == i}
                                   << (agent % kPositionPad);
        seen.words[i] = near_bits(positions.rows + first, positions.cols + first,
                                  at_most_pad(positions.n_agents - first), top, left,
                                  static_cast<short>(2 * reach)) &
                        ~self;
    }
    return seen;
}

// Of the seen agents that set the same cell, keeps the first: a cell is added once. Only agents on
// shared cells are compared, so the search is short.
template <int kWords>
inline Seen<kWords> without_duplicates(const Positions& positions, Seen<kWords> seen) {
    int first[kMaxPositions];  // the first agent on each shared cell
    int n = 0;
    for (int i = 0; i < kWords; ++i) {
        for (std::uint64_t bits = seen.words[i] & positions.shared[i]; bits; bits &= bits - 1) {
            const int agent = i * kPositionPad + lowest_bit(bits);
            bool known = false;
            for (int k = 0; k < n; ++k)
                known |= positions.cells[first[k]] == positions.cells[agent];
            first[n] = agent;
            n += !known;
            seen.words[i] &= ~(std::uint64_t{known} << (agent % kPositionPad));
        }
    }
    return seen;
}

}  // namespace

}  // namespace matrixworld
