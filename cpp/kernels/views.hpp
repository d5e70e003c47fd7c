// Views as numbers: cleared at once, then the few cells that other agents set, then the obstacle
// channel, which is copied. Included by kernels.cpp alone.
#pragma once

#include "kernels/look.hpp"

namespace matrixworld {

namespace {

constexpr int kPiece = 4 * kLanes;  // bytes

// Copies n >= kBytes bytes in pieces of a fixed size, which compile to plain loads and stores; the
// last piece overlaps the one before.
template <int kBytes>
inline void copy_pieces(const std::uint8_t* from, std::uint8_t* to, int n) {
    int i = 0;
    for (; i + kBytes <= n; i += kBytes) std::memcpy(to + i, from + i, kBytes);
    if (i < n) std::memcpy(to + n - kBytes, from + n - kBytes, kBytes);
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

// Sets n bytes to 0 in whole pieces: aligned ones but for the first and the last, which overlap
// their neighbours.
inline void clear(std::uint8_t* to, std::ptrdiff_t n) {
    const Vec zero{};
    if (n < 2 * kPiece) {
        for (std::ptrdiff_t i = 0; i < n; ++i) to[i] = 0;
        return;
    }
    store(reinterpret_cast<float*>(to), zero);
    auto i = static_cast<std::ptrdiff_t>(kPiece - reinterpret_cast<std::uintptr_t>(to) % kPiece);
    for (; i + kPiece <= n; i += kPiece) store(reinterpret_cast<float*>(to + i), zero);
    store(reinterpret_cast<float*>(to + n - kPiece), zero);
}

// Sets the cell of every agent that one agent sees. How many these are differs from view to view,
// so a loop's end is predicted badly: the first kMost are set without a branch. Where there are
// fewer, a cell of the obstacle channel is set instead, which is written afterwards in any case.
template <int kWords, typename Number>
inline void mark_others(const Positions& positions, int agent, int fov, Number* view) {
    constexpr int kMost = 2;
    const int unused = 2 * fov * fov;
    const Seen<kWords> seen = look<kWords>(positions, agent, fov);
    for (int i = 0; i < kWords; ++i) {
        const std::int32_t* cells = positions.cells + i * kPositionPad;
        std::uint64_t bits = seen.words[i];
        for (int k = 0; k < kMost; ++k, bits &= bits - 1) {
            const int cell = cells[lowest_bit(bits | std::uint64_t{1} << 63)] - seen.corner;
            const int mask = opaque(-static_cast<int>(bits != 0));
            view[unused + ((cell - unused) & mask)] = 1;
        }
        for (; bits; bits &= bits - 1) view[cells[lowest_bit(bits)] - seen.corner] = 1;
    }
}

template <int kFov, int kWords, typename Number>
void write_views(const Positions positions, const int* agents, int n_views,
                 const std::uint8_t* const* obstacles, int stride, Number* views) {
    const int fov = kFov ? kFov : positions.fov;  // a constant lets the compiler unroll the copies
    const int size = 3 * fov * fov;
    clear(reinterpret_cast<std::uint8_t*>(views),
          static_cast<std::ptrdiff_t>(sizeof(Number)) * size * n_views);
    for (int a = 0; a < positions.n_agents; ++a) {
        Number* const view = views + static_cast<std::ptrdiff_t>(agents[a]) * size;
        Number* const channel = view + 2 * fov * fov;
        mark_others<kWords>(positions, a, fov, view);
        if (stride == fov) {
            copy(obstacles[a], channel, fov * fov);
            continue;
        }
        for (int r = 0; r < fov; ++r) {
            copy(obstacles[a] + static_cast<std::ptrdiff_t>(r) * stride, channel + r * fov, fov);
        }
    }
}

constexpr int kUsualFov = 11;  // the default of `Config`

template <typename Number>
void write(const Positions& positions, const int* agents, int n_views,
           const std::uint8_t* const* obstacles, int stride, Number* views) {
    constexpr int kMost = kMaxPositions / kPositionPad;
    const bool few = positions.n_agents <= kPositionPad;
    const auto usual =
        few ? write_views<kUsualFov, 1, Number> : write_views<kUsualFov, kMost, Number>;
    const auto any = few ? write_views<0, 1, Number> : write_views<0, kMost, Number>;
    (positions.fov == kUsualFov ? usual : any)(positions, agents, n_views, obstacles, stride,
                                               views);
}

}  // namespace

}  // namespace matrixworld
