// A list of agents with room for all of them from the start.
#pragma once

#include <vector>

namespace matrixworld {

class AgentList {
  public:
    explicit AgentList(int n_agents) : agents_(static_cast<std::size_t>(n_agents) + 1) {}

    void clear() { n_ = 0; }
    void add(int agent) { add_if(true, agent); }
    // Adds without a branch; there is room for one that is not added.
    void add_if(bool wanted, int agent) {
        agents_[n_] = agent;
        n_ += wanted;
    }
    int take_last() { return agents_[--n_]; }

    bool empty() const { return n_ == 0; }
    std::size_t size() const { return n_; }
    int operator[](std::size_t i) const { return agents_[i]; }
    const int* begin() const { return agents_.data(); }
    const int* end() const { return agents_.data() + n_; }

  private:
    std::vector<int> agents_;
    std::size_t n_ = 0;
};

}  // namespace matrixworld
