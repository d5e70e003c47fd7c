// Where the agents of one world are, as those who look around read it (`Positions` in kernels.hpp).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"
#include "kernels/kernels.hpp"

namespace matrixworld {

enum Channel : int { kEvaders = 0, kPursuers = 1, kObstacles = 2, kChannels = 3 };

inline int channel(Team team) { return team == Team::Pursuer ? kPursuers : kEvaders; }

class PositionTable {
  public:
    PositionTable(int n_pursuers, int n_agents, int fov)
        : n_pursuers_(n_pursuers),
          n_agents_(n_agents),
          fov_(fov),
          rows_(room(n_agents), kFarOff),
          cols_(rows_.size(), kFarOff),
          cells_(rows_.size()),
          shared_(rows_.size() / kPositionPad) {}

    void put(int agent, int row, int col, bool shared) {
        const int drawn = channel(agent < n_pursuers_ ? Team::Pursuer : Team::Evader);
        rows_[agent] = static_cast<std::int16_t>(row);
        cols_[agent] = static_cast<std::int16_t>(col);
        cells_[agent] = (drawn * fov_ + row) * fov_ + col;
        const std::uint64_t bit = std::uint64_t{1} << (agent % kPositionPad);
        std::uint64_t& word = shared_[agent / kPositionPad];
        if (shared != ((word & bit) != 0)) word ^= bit;
    }
    void take(int agent) { rows_[agent] = kFarOff; }
    void take_all() { std::fill_n(rows_.begin(), n_agents_, kFarOff); }

    int row(int agent) const { return rows_[agent]; }
    int col(int agent) const { return cols_[agent]; }
    Positions positions() const {
        return {n_agents_, fov_, rows_.data(), cols_.data(), cells_.data(), shared_.data()};
    }

  private:
    static std::size_t room(int n_agents) {
        return static_cast<std::size_t>((n_agents + kPositionPad - 1) / kPositionPad) *
               kPositionPad;
    }

    int n_pursuers_;
    int n_agents_;
    int fov_;
    std::vector<std::int16_t> rows_;  // by agent; far off when gone
    std::vector<std::int16_t> cols_;
    std::vector<std::int32_t> cells_;
    std::vector<std::uint64_t> shared_;
};

}  // namespace matrixworld
