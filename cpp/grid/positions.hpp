// The positions of the agents of one world as flat arrays, which networks and views read after
// every turn. Plain data and constants only: kernels.cpp includes this file and is compiled for
// several instruction sets, so an inline function here could be linked into the rest of the program
// in a version that older processors cannot run. `PositionTable` owns and fills the arrays.
#pragma once

#include <cstdint>

namespace matrixworld {

// Agents are compared with a window in groups of this many: one bit each in a 64-bit word.
constexpr int kPositionPad = 64;
// Up to this many agents, comparing all positions with a window is faster than reading the window's
// cells from a bitboard.
constexpr int kMaxPositions = 2 * kPositionPad;
// The row of an agent that is gone: outside every view of the largest grid, and small enough that
// the difference of two rows fits 16 bits.
constexpr std::int16_t kOutOfView = -16384;

struct Positions {
    int n_agents;
    int fov;
    // By agent, with room for a multiple of kPositionPad; rows are kOutOfView for gone agents.
    const std::int16_t* rows;
    const std::int16_t* cols;
    // By agent: channel * fov * fov + row * fov + col. Subtracting top * fov + left gives the
    // agent's index in the flattened view (3, fov, fov) whose first cell is (top, left).
    const std::int32_t* cells;
    // A bit by agent, in words of kPositionPad: may a teammate be on the same cell?
    const std::uint64_t* shared;
};

}  // namespace matrixworld
