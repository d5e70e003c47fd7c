// Terrain: the obstacle map of a world, in the forms in which the engine reads it. Terrain does not
// change during an episode, so worlds share it by pointer: all worlds of a configured map, and all
// copies of a world, have one terrain, and a network that has summed the weights of its obstacles
// recognises it by its address. Only a world with obstacles of its own owns one.
#pragma once

#include <cstdint>

#include "grid/bitboard.hpp"
#include "grid/grid.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

struct Terrain {
    // Precondition: `map` is empty (no obstacles) or has rows * cols entries. The margin is what
    // half a view reaches beyond the grid.
    Terrain(const Grid& grid, int margin, const ByteArray& map = {});

    void set_obstacle(int cell);

    // Writes the obstacle map, (rows * cols) bytes, 0 or 1. Every map that leaves the engine
    // (snapshots, recordings, the state) is written here.
    void write_map(std::uint8_t* out) const;

    Grid grid;
    ByteArray kind;      // by cell, a CellKind
    Bitboard obstacles;  // without the border
    Plane blocked;       // obstacles and everything outside the grid
    bool has_obstacles = false;
};

}  // namespace matrixworld
