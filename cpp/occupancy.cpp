#include "occupancy.hpp"

namespace matrixworld {

Occupancy::Occupancy(const Grid& grid, int n_pursuers, int n_agents, int margin)
    : grid_(grid),
      n_pursuers_(n_pursuers),
      count_(decltype(count_)::Zero(kTeams, grid.n_cells())),
      first_(IntArray::Constant(grid.n_cells(), -1)),
      next_(IntArray::Constant(n_agents, -1)),
      previous_(IntArray::Constant(n_agents, -1)),
      boards_{Board(grid, margin), Board(grid, margin)} {}

void Occupancy::add(int agent, int cell) {
    const int head = first_[cell];
    next_[agent] = head;
    previous_[agent] = -1;
    if (head >= 0) previous_[head] = agent;
    first_[cell] = agent;

    const int team = static_cast<int>(this->team(agent));
    if (count_(team, cell)++ == 0) {
        ++distinct_[team];
        boards_[team].set(grid_.row(cell), grid_.col(cell));
    }
}

void Occupancy::remove(int agent, int cell) {
    const int before = previous_[agent];
    const int after = next_[agent];
    if (before >= 0) {
        next_[before] = after;
    } else {
        first_[cell] = after;
    }
    if (after >= 0) previous_[after] = before;

    const int team = static_cast<int>(this->team(agent));
    if (--count_(team, cell) == 0) {
        --distinct_[team];
        boards_[team].clear(grid_.row(cell), grid_.col(cell));
    }
}

}  // namespace matrixworld
