// For each cell a list of agents.
#pragma once

#include <vector>

#include "grid/grid.hpp"

namespace matrixworld {

// In no particular order: for (int agent : lists.at(cell)).
class CellLists {
  public:
    CellLists(const Grid& grid, int n_agents)
        : first_(IntArray::Constant(grid.n_cells(), -1)),
          next_(IntArray::Constant(n_agents, -1)),
          previous_(IntArray::Constant(n_agents, -1)) {}

    class Range {
      public:
        class Iterator {
          public:
            Iterator(const int* next, int agent) : next_(next), agent_(agent) {}
            int operator*() const { return agent_; }
            Iterator& operator++() {
                agent_ = next_[agent_];
                return *this;
            }
            bool operator!=(const Iterator& other) const { return agent_ != other.agent_; }

          private:
            const int* next_;
            int agent_;
        };

        Range(const int* next, int first) : next_(next), first_(first) {}
        Iterator begin() const { return {next_, first_}; }
        Iterator end() const { return {next_, -1}; }

      private:
        const int* next_;
        int first_;
    };

    Range at(int cell) const { return {next_.data(), first_[cell]}; }

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
