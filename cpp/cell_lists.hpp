// For each cell a list of agents.
#pragma once

#include <vector>

#include "grid.hpp"

namespace matrixworld {

// In no particular order: for (int a = lists.first(cell); a >= 0; a = lists.next(a)).
class CellLists {
  public:
    CellLists(const Grid& grid, int n_agents)
        : first_(IntArray::Constant(grid.n_cells(), -1)),
          next_(IntArray::Constant(n_agents, -1)),
          previous_(IntArray::Constant(n_agents, -1)) {}

    int first(int cell) const { return first_[cell]; }
    int next(int agent) const { return next_[agent]; }

    void add(int agent, int cell) {
        const int head = first_[cell];
        next_[agent] = head;
        previous_[agent] = -1;
        if (head >= 0) previous_[head] = agent;
        first_[cell] = agent;
    }

    void remove(int agent, int cell) {
        const int before = previous_[agent];
        const int after = next_[agent];
        if (before >= 0) {
            next_[before] = after;
        } else {
            first_[cell] = after;
        }
        if (after >= 0) previous_[after] = before;
    }

    void clear(int cell) { first_[cell] = -1; }

  private:
    IntArray first_;     // by cell
    IntArray next_;      // by agent
    IntArray previous_;  // by agent
};

}  // namespace matrixworld
