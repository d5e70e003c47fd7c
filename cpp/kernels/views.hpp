// Views as numbers. Included by kernels.cpp alone, like kernel_vector.hpp.
#pragma once

#include "kernels/look.hpp"

namespace matrixworld {

namespace {

constexpr int kPiece = 4 * kLanes;  // bytes

// Copies n bytes piece by piece; the last piece overlaps the one before.
template <int kBytes>
inline void copy_pieces(const std::uint8_t* from, std::uint8_t* to, int n) {
    int i = 0;
    for (; i + kBytes <= n; i += kBytes) __builtin_memcpy(to + i, from + i, kBytes);
    if (i < n) __builtin_memcpy(to + n - kBytes, from + n - kBytes, kBytes);
}

inline void copy(const std::uint8_t* from, std::uint8_t* to, int n) {
    if (n >= kPiece) {
        copy_pieces<kPiece>(from, to, n);
    } else if (n >= 8) {
        copy_pieces<8>(from, to, n);
    } else {
        copy_pieces<1>(from, to, n);
    }
}

inline void copy(const std::uint8_t* from, float* to, int n) {
    for (int i = 0; i < n; ++i) to[i] = from[i];
}

// Sets n bytes to 0; whole aligned pieces but at the ends, where the last overlaps the one before.
inline void clear(std::uint8_t* to, long n) {
    const Vec zero{};
    if (n < 2 * kPiece) {
        for (long i = 0; i < n; ++i) to[i] = 0;
        return;
    }
    store(reinterpret_cast<float*>(to), zero);
    long i = kPiece - static_cast<long>(reinterpret_cast<std::uintptr_t>(to) % kPiece);
    for (; i + kPiece <= n; i += kPiece) store(reinterpret_cast<float*>(to + i), zero);
    store(reinterpret_cast<float*>(to + n - kPiece), zero);
}

// The others that an agent sees, each one set cell. Most see a few: so many are marked without a
// branch, those that are not there in a cell of the obstacles, which are drawn afterwards.
template <typename Number>
inline void mark_others(const Positions& positions, int agent, int fov, Number* view) {
    constexpr int kMost = 2;
    const int unused = 2 * fov * fov;
    const Seen seen = look(positions, agent, fov);
    for (int i = 0; i < seen.n_words; ++i) {
        const std::int32_t* cells = positions.cells + i * kPositionPad;
        std::uint64_t bits = seen.words[i];
        for (int k = 0; k < kMost; ++k, bits &= bits - 1) {
            const int cell = cells[__builtin_ctzll(bits | std::uint64_t{1} << 63)] - seen.corner;
            int there = -static_cast<int>(bits != 0);
            __asm__("" : "+r"(there));  // or the compiler makes a branch of it
            view[unused + ((cell - unused) & there)] = 1;
        }
        for (; bits; bits &= bits - 1) view[cells[__builtin_ctzll(bits)] - seen.corner] = 1;
    }
}

template <int kFov, typename Number>
void draw_views(const Positions& positions, const std::uint8_t* const* obstacles, int stride,
                Number* views) {
    const int fov = kFov ? kFov : positions.fov;  // kFov where the compiler is to know it
    const int size = 3 * fov * fov;
    clear(reinterpret_cast<std::uint8_t*>(views),
          static_cast<long>(sizeof(Number)) * size * positions.n_agents);
    for (int a = 0; a < positions.n_agents; ++a) {
        if (positions.rows[a] == kOutOfView) continue;
        Number* const view = views + static_cast<long>(a) * size;
        Number* const channel = view + 2 * fov * fov;
        mark_others(positions, a, fov, view);
        if (stride == fov) {
            copy(obstacles[a], channel, fov * fov);
            continue;
        }
        for (int r = 0; r < fov; ++r) {
            copy(obstacles[a] + static_cast<long>(r) * stride, channel + r * fov, fov);
        }
    }
}

constexpr int kUsualFov = 11;

template <typename Number>
void draw(const Positions& positions, const std::uint8_t* const* obstacles, int stride,
          Number* views) {
    if (positions.fov == kUsualFov) {
        draw_views<kUsualFov>(positions, obstacles, stride, views);
    } else {
        draw_views<0>(positions, obstacles, stride, views);
    }
}

}  // namespace

}  // namespace matrixworld
