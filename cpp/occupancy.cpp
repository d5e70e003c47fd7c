#include "occupancy.hpp"

#include "kernels.hpp"

namespace matrixworld {

namespace {

constexpr std::int16_t kFarOff = -16384;  // out of every view of the largest grid

std::size_t room(int n_agents) {
    return static_cast<std::size_t>((n_agents + kPlacePad - 1) / kPlacePad) * kPlacePad;
}

constexpr std::uint64_t both(std::uint64_t bits) { return bits | bits << Heading::kBits; }
constexpr std::uint64_t opposite(int way) { return both(std::uint64_t{1} << kOpposite[way]); }

}  // namespace

const std::array<Headings::Word, kDiagonalMoves> Headings::kOppositeWays = {
    0,           opposite(1), opposite(2), opposite(3), opposite(4),
    opposite(5), opposite(6), opposite(7), opposite(8)};

Occupancy::Occupancy(const Grid& grid, int n_pursuers, int n_agents, int margin, bool for_networks,
                     bool keeps_lists)
    : grid_(grid),
      n_pursuers_(n_pursuers),
      n_agents_(n_agents),
      for_networks_(for_networks),
      keeps_lists_(keeps_lists),
      words_(static_cast<std::size_t>(grid.n_cells()), 0),
      headings_(words_.data()),
      lists_(grid, n_agents),
      rows_(room(n_agents), kFarOff),
      cols_(room(n_agents), kFarOff),
      boards_{Board(grid, margin), Board(grid, margin)} {}

void Occupancy::add(int agent, int cell) {
    anybody_ = true;
    headings_.post(cell, team(agent), Heading::by(0, false));
    if (keeps_lists_) lists_.add(agent, cell);
    if (for_networks_) show(agent, cell);
}

void Occupancy::remove(int agent, int cell) {
    headings_.withdraw(cell, team(agent), 0);
    if (keeps_lists_) lists_.remove(agent, cell);
    if (for_networks_) hide(agent);
    if (for_networks_ && keeps_boards() && count(cell, team(agent)) > 0) {
        boards_[static_cast<int>(team(agent))].set(grid_.row(cell), grid_.col(cell));
    }
}

void Occupancy::clear(const std::vector<int>& living, const IntArray& cell) {
    lift(living, cell);
    anybody_ = false;
}

void Occupancy::lift(const std::vector<int>& cast, const IntArray& cell) {
    if (!anybody_) return;
    const Headings headings = headings_;
    const int* const cells = cell.data();
    for (int a : cast) headings.clear(cells[a]);
    if (keeps_lists_) {
        for (int a : cast) lists_.remove(a, cell[a]);
    }
    if (for_networks_) {
        for (int a : cast) hide(a);
    }
}

void Occupancy::land(const std::vector<int>& cast, const IntArray& cell) {
    anybody_ = true;
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
