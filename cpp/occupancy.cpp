#include "occupancy.hpp"

#include "kernels.hpp"

namespace matrixworld {

namespace {

constexpr std::int16_t kFarOff = -16384;  // out of every view of the largest grid

std::size_t room(int n_agents) {
    return static_cast<std::size_t>((n_agents + kPlacePad - 1) / kPlacePad) * kPlacePad;
}

}  // namespace

Occupancy::Occupancy(const Grid& grid, int n_pursuers, int n_agents, int margin, bool for_networks)
    : grid_(grid),
      n_pursuers_(n_pursuers),
      for_networks_(for_networks),
      count_(decltype(count_)::Zero(kTeams, grid.n_cells())),
      first_(IntArray::Constant(grid.n_cells(), -1)),
      next_(IntArray::Constant(n_agents, -1)),
      previous_(IntArray::Constant(n_agents, -1)),
      rows_(room(n_agents), kFarOff),
      cols_(room(n_agents), kFarOff),
      boards_{Board(grid, margin), Board(grid, margin)} {}

void Occupancy::add(int agent, int cell) {
    const int head = first_[cell];
    next_[agent] = head;
    previous_[agent] = -1;
    if (head >= 0) previous_[head] = agent;
    first_[cell] = agent;

    const int team = static_cast<int>(this->team(agent));
    const bool first = count_(team, cell)++ == 0;
    distinct_[team] += first;
    if (!for_networks_) return;
    const int row = grid_.row(cell);
    const int col = grid_.col(cell);
    rows_[agent] = static_cast<std::int16_t>(row);
    cols_[agent] = static_cast<std::int16_t>(col);
    if (first) boards_[team].set(row, col);
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
    const bool last = --count_(team, cell) == 0;
    distinct_[team] -= last;
    if (!for_networks_) return;
    if (last) boards_[team].clear(rows_[agent], cols_[agent]);
    rows_[agent] = kFarOff;
    cols_[agent] = kFarOff;
}

}  // namespace matrixworld
