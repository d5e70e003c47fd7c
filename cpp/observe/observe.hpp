// Observations. The view of an agent is a square window of `fov` x `fov` cells centred on it, in
// the channels evaders, pursuers, obstacles. Cells outside the grid are obstacles; the agent itself
// is not in its view, a teammate on its cell is; a gone agent sees zeros. Views have two forms:
// numbers, for callers, and the list of the cells that are set, for networks, which add one row of
// weights for each.
//
//     Observer observer(setup);                            // one for each thread
//     std::vector<float> views(n_agents * 3 * fov * fov);
//     observer.write(world, scratch.occupancy, views.data());
#pragma once

#include <cstdint>
#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"
#include "grid/bitboard.hpp"
#include "grid/grid.hpp"
#include "observe/crowd.hpp"

namespace matrixworld {

// Writes views as numbers. Holds memory of its own, so each thread needs one; it serves all worlds
// of one configuration.
class Observer {
  public:
    explicit Observer(const Setup& setup);

    // Writes the views of all agents, (A, 3, fov, fov) bytes or floats, 0 or 1. Precondition: the
    // world has entered the occupancy.
    template <typename Number>
    void write(const World& world, const Occupancy& occupancy, Number* out);

  private:
    // Up to kMaxPositions agents: their positions are compared with each window.
    template <typename Number>
    void write_from_positions(const World& world, Number* out);
    void make_border(const Grid& grid);
    const std::uint8_t* border(int row, int col) const;

    // More agents: they are marked on a plane for each team, and windows of the planes are copied.
    template <typename Number>
    void write_from_planes(const World& world, const Occupancy& occupancy, Number* out);
    void mark(const World& world, std::uint8_t value);

    int fov_;
    Crowd crowd_;
    std::vector<const std::uint8_t*> obstacles_;  // by living agent: the first cell of its window
    BorderCases cases_;
    std::vector<std::uint8_t> border_;  // (n cases, fov, fov) visible border; empty for large views

    Plane planes_[kTeams];  // empty between two calls
};

// Lists the cells that agents set in the view of a living agent as indices into the flattened (3, fov,
// fov) view, each once, and returns how many there are. Preconditions: `out` has room for 3 * fov *
// fov; the world has entered the occupancy.
int list_agents(const World& world, const Occupancy& occupancy, int agent, int* out);

// Writes the obstacles in the view from a cell, without the border, as fov * fov bits one after the
// other, the first in the lowest bit of the first word. Precondition: `words` has room for
// n_obstacle_words(fov).
inline int n_obstacle_words(int fov) { return fov * fov / 64 + 1; }
void pack_obstacles(const World& world, int row, int col, std::uint64_t* words);

// Writes the whole world, (3, rows, cols) bytes, 0 or 1, in the channels of the views.
void write_state(const World& world, std::uint8_t* out);

}  // namespace matrixworld
