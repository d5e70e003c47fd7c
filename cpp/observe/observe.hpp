// What one agent sees: a square window of `fov` x `fov` cells centred on it, in three channels,
// evaders, pursuers, obstacles. Outside the grid is obstacle; the agent itself is not drawn, a
// teammate on its cell is. Two forms: numbers for a caller, and the list of the cells that are set.
#pragma once

#include <cstdint>
#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"
#include "grid/border.hpp"
#include "grid/plane.hpp"
#include "grid/position_table.hpp"

namespace matrixworld {

// Writes views as numbers; scratch memory of one thread, for worlds of one configuration.
class Observer {
  public:
    explicit Observer(const Setup& setup);

    // The views of all agents, (A, 3, fov, fov) bytes or floats, 0 or 1; a gone agent sees zeros.
    template <typename Number>
    void write(const World& world, const Occupancy& occupancy, Number* out);

  private:
    // Few agents: who sees whom is found by their places.
    template <typename Number>
    void draw(const World& world, Number* out);
    void make_border(const Grid& grid);
    const std::uint8_t* border(int row, int col) const;

    // Many: the agents are put on planes, of which windows are copied.
    template <typename Number>
    void copy(const World& world, const Occupancy& occupancy, Number* out);
    void mark(const World& world, std::uint8_t value);

    int fov_;
    PositionTable position_table_;
    std::vector<const std::uint8_t*> obstacles_;  // by agent: what it sees of them
    BorderCases cases_;
    std::vector<std::uint8_t> border_;  // (n cases, fov, fov); none where views are large

    Plane planes_[kTeams];  // empty between two calls
};

// Writes the inputs that are set in the view of a living agent, each as an index into the
// flattened (3, fov, fov) view, each once; of agents, and of obstacles without the border. Returns
// how many. `out` has room for 3 * fov * fov.
int list_agents(const World& world, const Occupancy& occupancy, int agent, int* out);
int list_obstacles(const World& world, int cell, int* out);

// Writes the whole world, (3, rows, cols) bytes.
void write_state(const World& world, std::uint8_t* out);

}  // namespace matrixworld
