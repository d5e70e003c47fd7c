#include "game/occupancy.hpp"

namespace matrixworld {

namespace {

// The same bits for both teams.
constexpr std::uint64_t both(std::uint64_t bits) { return bits | bits << Reservation::kBits; }
constexpr std::uint64_t opposite(int move) { return both(std::uint64_t{1} << kOpposite[move]); }

}  // namespace

const std::array<ReservationTable::Word, kDiagonalMoves> ReservationTable::kOppositeMoves = {
    0,           opposite(1), opposite(2), opposite(3), opposite(4),
    opposite(5), opposite(6), opposite(7), opposite(8)};

Occupancy::Occupancy(const Grid& grid, int n_pursuers, int n_agents, int fov, bool for_networks,
                     bool keeps_lists)
    : grid_(grid),
      n_pursuers_(n_pursuers),
      n_agents_(n_agents),
      for_networks_(for_networks),
      keeps_lists_(keeps_lists),
      words_(static_cast<std::size_t>(grid.n_cells()), 0),
      reservations_(words_.data()),
      lists_(grid, n_agents),
      position_table_(n_pursuers, n_agents, fov),
      bitboards_{Bitboard(grid, fov / 2), Bitboard(grid, fov / 2)} {}

void Occupancy::add(int agent, int cell) {
    in_use_ = true;
    reservations_.reserve(cell, team(agent), Reservation::of(0, false));
}

void Occupancy::remove(int agent, int cell) {
    reservations_.release(cell, team(agent), 0);
    if (keeps_lists_) lists_.remove(agent, cell);
    if (for_networks_) clear_position(agent);
    // The cell's bit is shared: it is set again for a teammate that stays there.
    if (for_networks_ && keeps_bitboards() && count(cell, team(agent)) > 0) {
        bitboards_[static_cast<int>(team(agent))].set(grid_.row(cell), grid_.col(cell));
    }
}

void Occupancy::clear(const std::vector<int>& living, const IntArray& cell) {
    release(living, cell);
    in_use_ = false;
}

void Occupancy::release(const std::vector<int>& participants, const IntArray& cell) {
    if (!in_use_) return;
    // Copies, which the compiler knows that the writes below do not change.
    const ReservationTable reservations = reservations_;
    const int* const cells = cell.data();
    for (int a : participants) reservations.clear(cells[a]);
    if (keeps_lists_) {
        for (int a : participants) lists_.remove(a, cell[a]);
    }
    if (for_networks_) {
        for (int a : participants) clear_position(a);
    }
}

void Occupancy::occupy(const std::vector<int>& participants, const IntArray& cell) {
    in_use_ = true;
    if (keeps_lists_) {
        for (int a : participants) {
            if (cell[a] != kGone) lists_.add(a, cell[a]);
        }
    }
    if (for_networks_) {
        for (int a : participants) {
            if (cell[a] != kGone) set_position(a, cell[a]);
        }
    }
}

void Occupancy::make_lists(const std::vector<int>& living, const IntArray& cell) {
    if (keeps_lists_ || !listed_.empty()) return;
    for (int a : living) {
        if (cell[a] == kGone) continue;
        lists_.add(a, cell[a]);
        listed_.push_back(cell[a]);
    }
}

void Occupancy::clear_lists() {
    for (int cell : listed_) lists_.clear(cell);
    listed_.clear();
}

void Occupancy::set_position(int agent, int cell) {
    const int row = grid_.row(cell);
    const int col = grid_.col(cell);
    position_table_.set(agent, row, col, reservations_.at(cell, team(agent)).several());
    if (keeps_bitboards()) bitboards_[static_cast<int>(team(agent))].set(row, col);
}

void Occupancy::clear_position(int agent) {
    if (keeps_bitboards()) {
        bitboards_[static_cast<int>(team(agent))].clear(position_table_.row(agent),
                                                        position_table_.col(agent));
    }
    position_table_.remove(agent);
}

}  // namespace matrixworld
