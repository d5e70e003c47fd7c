#include "occupancy.hpp"

#include "kernels.hpp"

namespace matrixworld {

namespace {

constexpr std::int16_t kFarOff = -16384;  // out of every view of the largest grid

std::size_t room(int n_agents) {
    return static_cast<std::size_t>((n_agents + kPlacePad - 1) / kPlacePad) * kPlacePad;
}

}  // namespace

Occupancy::Occupancy(const Grid& grid, int n_pursuers, int n_agents, int margin, bool for_networks,
                     bool keeps_lists)
    : grid_(grid),
      n_pursuers_(n_pursuers),
      n_agents_(n_agents),
      for_networks_(for_networks),
      keeps_lists_(keeps_lists),
      words_(decltype(words_)::Zero(grid.n_cells())),
      lists_(grid, n_agents),
      rows_(room(n_agents), kFarOff),
      cols_(room(n_agents), kFarOff),
      boards_{Board(grid, margin), Board(grid, margin)} {}

void Occupancy::add(int agent, int cell) {
    post(team(agent), cell, Heading::by(0, false));
    if (keeps_lists_) lists_.add(agent, cell);
    if (for_networks_) show(agent, cell);
}

void Occupancy::remove(int agent, int cell) {
    withdraw(team(agent), cell, 0);
    if (keeps_lists_) lists_.remove(agent, cell);
    if (for_networks_) hide(agent);
    if (for_networks_ && keeps_boards() && count(cell, team(agent)) > 0) {
        boards_[static_cast<int>(team(agent))].set(grid_.row(cell), grid_.col(cell));
    }
}

void Occupancy::lift(const std::vector<int>& cast, const IntArray& cell) {
    for (int a : cast) words_[cell[a]] = 0;
    if (keeps_lists_) {
        for (int a : cast) lists_.remove(a, cell[a]);
    }
    if (for_networks_) {
        for (int a : cast) hide(a);
    }
}

void Occupancy::withdraw(Team team, int cell, int way) {
    const Word left = words_[cell] - cell_word::one(team);
    const bool empty = (left & cell_word::kCounts) == 0;
    words_[cell] = empty ? 0 : left & ~cell_word::of_team(team, Heading(1u << way));
}

void Occupancy::land(const std::vector<int>& cast, const IntArray& cell) {
    if (keeps_lists_) {
        for (int a : cast) {
            if (cell[a] != kGone) lists_.add(a, cell[a]);
        }
    }
    if (for_networks_) {
        for (int a : cast) {
            if (cell[a] != kGone) show(a, cell[a]);
        }
    }
}

void Occupancy::list(const std::vector<int>& living, const IntArray& cell) {
    if (keeps_lists_ || !listed_.empty()) return;
    for (int a : living) {
        if (cell[a] == kGone) continue;
        lists_.add(a, cell[a]);
        listed_.push_back(cell[a]);
    }
}

void Occupancy::unlist() {
    for (int cell : listed_) lists_.clear(cell);
    listed_.clear();
}

void Occupancy::show(int agent, int cell) {
    rows_[agent] = static_cast<std::int16_t>(grid_.row(cell));
    cols_[agent] = static_cast<std::int16_t>(grid_.col(cell));
    if (keeps_boards()) boards_[static_cast<int>(team(agent))].set(rows_[agent], cols_[agent]);
}

void Occupancy::hide(int agent) {
    if (keeps_boards()) boards_[static_cast<int>(team(agent))].clear(rows_[agent], cols_[agent]);
    rows_[agent] = kFarOff;
    cols_[agent] = kFarOff;
}

}  // namespace matrixworld
