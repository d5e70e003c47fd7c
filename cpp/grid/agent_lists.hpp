// Lists of agents that never allocate while a world is played: one list of agents, and one list for
// each cell of the grid.
//
//     AgentList held(n_agents);                      CellLists lists(grid, n_agents);
//     held.add(agent);                               lists.add(agent, cell);
//     for (int agent : held) ...                     for (int agent : lists.at(cell)) ...
#pragma once

#include <vector>

#include "grid/grid.hpp"

namespace matrixworld {

// A list with room for every agent from the start.
class AgentList {
  public:
    explicit AgentList(int n_agents) : agents_(static_cast<std::size_t>(n_agents) + 1) {}

    void clear() { n_ = 0; }
    void add(int agent) { add_if(true, agent); }
    // Adds without a branch, which would often be predicted wrongly: the agent is written in any
    // case (there is room for one more), and kept only if it is wanted.
    void add_if(bool wanted, int agent) {
        agents_[n_] = agent;
        n_ += wanted;
    }

    bool empty() const { return n_ == 0; }
    std::size_t size() const { return n_; }
    int operator[](std::size_t i) const { return agents_[i]; }
    const int* begin() const { return agents_.data(); }
    const int* end() const { return agents_.data() + n_; }

  private:
    std::vector<int> agents_;
    std::size_t n_ = 0;
};

// The agents on each cell, in no particular order: doubly linked lists threaded through arrays by
// agent, so that adding and removing cost O(1) and nothing depends on the number of cells.
// Precondition of `add`: the agent is on no list. Precondition of `remove`: it is on this one.
class CellLists {
  public:
    CellLists(const Grid& grid, int n_agents)
        : first_(IntArray::Constant(grid.n_cells(), kEnd)),
          next_(IntArray::Constant(n_agents, kEnd)),
          previous_(IntArray::Constant(n_agents, kEnd)) {}

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
        Iterator end() const { return {next_, kEnd}; }

      private:
        const int* next_;
        int first_;
    };

    Range at(int cell) const { return {next_.data(), first_[cell]}; }

    void add(int agent, int cell) {
        const int head = first_[cell];
        next_[agent] = head;
        previous_[agent] = kEnd;
        if (head != kEnd) previous_[head] = agent;
        first_[cell] = agent;
    }

    void remove(int agent, int cell) {
        const int before = previous_[agent];
        const int after = next_[agent];
        if (before != kEnd) {
            next_[before] = after;
        } else {
            first_[cell] = after;
        }
        if (after != kEnd) previous_[after] = before;
    }

    // Forgets the list of one cell; the links of its agents need no cleaning, `add` overwrites
    // them.
    void clear(int cell) { first_[cell] = kEnd; }

  private:
    static constexpr int kEnd = -1;

    IntArray first_;     // by cell
    IntArray next_;      // by agent
    IntArray previous_;  // by agent
};

}  // namespace matrixworld
