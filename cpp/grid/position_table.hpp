// The table of agents' positions that views and networks read (`Positions`). The occupancy updates
// it turn by turn, in O(1) an agent, so that nothing is collected anew before each look.
//
//     PositionTable table(n_pursuers, n_agents, fov);
//     table.set(agent, row, col, shared);
//     table.remove(agent);
//     kernels().write_byte_views(table.positions(), ...);
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "grid/positions.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

class PositionTable {
  public:
    PositionTable(int n_pursuers, int n_agents, int fov)
        : n_pursuers_(n_pursuers),
          n_agents_(n_agents),
          fov_(fov),
          rows_(room(n_agents), kOutOfView),
          cols_(rows_.size(), kOutOfView),
          cells_(rows_.size()),
          shared_(rows_.size() / kPositionPad) {}

    // `shared`: may a teammate be on the same cell?
    void set(int agent, int row, int col, bool shared) {
        const int own = channel(agent < n_pursuers_ ? Team::Pursuer : Team::Evader);
        rows_[agent] = static_cast<std::int16_t>(row);
        cols_[agent] = static_cast<std::int16_t>(col);
        cells_[agent] = (own * fov_ + row) * fov_ + col;
        const std::uint64_t bit = std::uint64_t{1} << (agent % kPositionPad);
        std::uint64_t& word = shared_[agent / kPositionPad];
        if (shared != ((word & bit) != 0)) word ^= bit;
    }
    // One coordinate out of view is enough: an agent is seen where both lie in the window.
    void remove(int agent) { rows_[agent] = kOutOfView; }
    void remove_all() { std::fill_n(rows_.begin(), n_agents_, kOutOfView); }

    int row(int agent) const { return rows_[agent]; }
    int col(int agent) const { return cols_[agent]; }
    Positions positions() const {
        return {n_agents_, fov_, rows_.data(), cols_.data(), cells_.data(), shared_.data()};
    }

  private:
    // Whole groups, so that the last one can be read without a test for its end.
    static std::size_t room(int n_agents) {
        return static_cast<std::size_t>((n_agents + kPositionPad - 1) / kPositionPad) *
               kPositionPad;
    }

    int n_pursuers_;
    int n_agents_;
    int fov_;
    std::vector<std::int16_t> rows_;  // by agent; kOutOfView when gone
    std::vector<std::int16_t> cols_;
    std::vector<std::int32_t> cells_;
    std::vector<std::uint64_t> shared_;
};

}  // namespace matrixworld
