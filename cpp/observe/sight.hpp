// The other agents in an agent's view, as a list of cells.
#pragma once

#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"

namespace matrixworld {

// A cell relative to an agent's own cell.
struct Offset {
    int row;
    int col;
};
using Offsets = std::vector<Offset>;

// The other agents in an agent's view.
class Sight {
  public:
    explicit Sight(int fov) : set_(static_cast<std::size_t>(kChannels) * fov * fov) {}

    void look(const World& world, const Occupancy& occupancy, int agent);

    // Cells that hold adversaries, or teammates; each cell once.
    const Offsets& adversaries() const { return adversaries_; }
    const Offsets& teammates() const { return teammates_; }
    bool is_free(Offset cell) const;                  // inside the grid and no obstacle
    bool is_blocked(Offset cell) const;               // the contrary, of any cell in view
    int moves(Offset from, Offset to) const;          // the least number of moves
    int n_neighbors() const { return n_moves_ - 1; }  // cells that one move reaches

  private:
    const World* world_ = nullptr;
    Offset own_{0, 0};  // row and column of the agent
    int n_moves_ = 0;
    Offsets adversaries_;
    Offsets teammates_;
    std::vector<int> set_;  // indices into the flattened view that hold an agent
};

}  // namespace matrixworld
