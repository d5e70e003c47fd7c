// Who stands where: scratch memory of one thread, shared by all the worlds that it plays. A world
// puts its agents in, is played and looked at, and takes them out again; every operation costs
// O(1), whatever the size of the grid. For each cell: how many agents of each team, and the list
// of who. For each team: a board of bits, framed by `margin` empty cells so that a window around
// any cell can be read without a test.
#pragma once

#include <cstdint>
#include <vector>

#include "board.hpp"
#include "grid.hpp"

namespace matrixworld {

class Occupancy {
  public:
    // Without `for_networks`, rows, cols and boards, which networks look at, are left empty.
    Occupancy(const Grid& grid, int n_pursuers, int n_agents, int margin, bool for_networks);

    void add(int agent, int cell);
    void remove(int agent, int cell);

    int count(int cell, Team team) const { return count_(static_cast<int>(team), cell); }
    bool empty(int cell) const { return first_[cell] < 0; }
    // Cells that hold at least one agent of the team.
    int distinct_cells(Team team) const { return distinct_[static_cast<int>(team)]; }
    const Board& board(Team team) const { return boards_[static_cast<int>(team)]; }

    // The agents on a cell, in no particular order: for (a = first(cell); a >= 0; a = next(a)).
    int first(int cell) const { return first_[cell]; }
    int next(int agent) const { return next_[agent]; }

    // Row and column by agent, with room for a multiple of kPlacePad; far off when not here.
    const std::int16_t* rows() const { return rows_.data(); }
    const std::int16_t* cols() const { return cols_.data(); }
    int n_agents() const { return static_cast<int>(next_.size()); }

    Team team(int agent) const { return agent < n_pursuers_ ? Team::Pursuer : Team::Evader; }

  private:
    const Grid grid_;
    int n_pursuers_;
    bool for_networks_;
    Eigen::Array<int, kTeams, Eigen::Dynamic> count_;
    IntArray first_;
    IntArray next_;
    IntArray previous_;
    std::vector<std::int16_t> rows_;
    std::vector<std::int16_t> cols_;
    int distinct_[kTeams] = {0, 0};
    Board boards_[kTeams];
};

}  // namespace matrixworld
