// The positions of the living agents of one world side by side, in the order of their numbers: what
// views are written from, and what networks read that decide for many worlds one after the other.
// Agents that are gone cost nothing.
//
//     Crowd crowd(setup);
//     crowd.gather(world, scratch.occupancy);      // after every turn
//     crowd.positions().rows[i];                   // of world.living()[i]
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"
#include "grid/positions.hpp"

namespace matrixworld {

// Precondition: at most kMaxPositions agents.
class Crowd {
  public:
    explicit Crowd(const Config& config) : fov_(config.fov) {
        std::fill_n(rows_, kMaxPositions, kOutOfView);
    }

    // For networks, which ask whether agents share a cell. Precondition: the world has entered the
    // occupancy.
    void gather(const World& world, const Occupancy& occupancy) {
        gather(world);
        if (world.may_overlap() || any_shared_) mark_shared(world, occupancy);
    }

    // For views.
    void gather(const World& world) {
        const Grid grid = world.grid();
        const int* const cells = world.cells().data();
        const int* const living = world.living().data();
        const int n = static_cast<int>(world.living().size());
        const int n_pursuers = world.n_living(Team::Pursuer);
        for (int i = 0; i < n; ++i) {
            const int row = grid.row(cells[living[i]]);
            const int col = grid.col(cells[living[i]]);
            const int own = channel(i < n_pursuers ? Team::Pursuer : Team::Evader);
            rows_[i] = static_cast<std::int16_t>(row);
            cols_[i] = static_cast<std::int16_t>(col);
            cells_[i] = (own * fov_ + row) * fov_ + col;
        }
        if (n < n_) std::fill(rows_ + n, rows_ + n_, kOutOfView);
        n_ = n;
    }

    Positions positions() const { return {n_, fov_, rows_, cols_, cells_, shared_}; }

  private:
    void mark_shared(const World& world, const Occupancy& occupancy) {
        std::fill(std::begin(shared_), std::end(shared_), 0);
        any_shared_ = false;
        for (int i = 0; i < n_; ++i) {
            const int agent = world.living()[i];
            if (occupancy.count(world.cell(agent), world.team(agent)) < 2) continue;
            shared_[i / kPositionPad] |= std::uint64_t{1} << (i % kPositionPad);
            any_shared_ = true;
        }
    }

    int fov_;
    int n_ = 0;
    bool any_shared_ = false;
    alignas(64) std::int16_t rows_[kMaxPositions];  // by place; kOutOfView beyond the last
    alignas(64) std::int16_t cols_[kMaxPositions]{};
    alignas(64) std::int32_t cells_[kMaxPositions]{};
    std::uint64_t shared_[kMaxPositions / kPositionPad]{};
};

}  // namespace matrixworld
