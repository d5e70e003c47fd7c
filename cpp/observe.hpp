// What one agent sees: a square window of `fov` x `fov` cells centred on it, in three channels,
// evaders, pursuers, obstacles. Outside the grid is obstacle; the agent itself is not drawn, a
// teammate on its cell is. Two forms: bytes for a caller, and the list of the cells that are set
// for a network whose first layer is a sum over them.
#pragma once

#include <cstdint>

#include "occupancy.hpp"
#include "plane.hpp"
#include "world.hpp"

namespace matrixworld {

enum Channel : int { kEvaders = 0, kPursuers = 1, kObstacles = 2, kChannels = 3 };

// Writes views as numbers; scratch memory of one thread, for worlds of one configuration.
class Lens {
  public:
    Lens(const Grid& grid, int fov);

    // The views of all agents, (A, 3, fov, fov) bytes or floats, 0 or 1; a gone agent sees zeros.
    template <typename Number>
    void write(const World& world, const Occupancy& occupancy, Number* out);

  private:
    // Puts the agents on the planes, or takes them off.
    void mark(const World& world, std::uint8_t value);

    Plane planes_[kTeams];  // empty between two calls
    int fov_;
};

// Writes the inputs that are set in the view of a living agent, each as an index into the
// flattened (3, fov, fov) view, each once, without those outside the grid; returns how many.
// `out` has room for 3 * fov * fov.
int list_view(const World& world, const Occupancy& occupancy, int agent, int* out);

// Writes the whole world, (3, rows, cols) bytes.
void write_state(const World& world, std::uint8_t* out);

}  // namespace matrixworld
