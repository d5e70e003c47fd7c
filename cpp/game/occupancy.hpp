// Who heads for each cell: scratch memory of one thread, shared by all the worlds that it plays.
// Between two turns everybody heads for where it stands; a turn lifts its agents and posts them
// where they mean to go, and whoever must not go there is withdrawn and posted elsewhere. A world
// puts its agents in, is played and looked at, and takes them out again; every operation costs
// O(1) an agent, whatever the size of the grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/bitboard.hpp"
#include "grid/cell_lists.hpp"
#include "grid/grid.hpp"
#include "grid/position_table.hpp"

namespace matrixworld {

// The agents of one team that head for a cell: how many, and which of the nine ways to get there
// are taken (way 0: by standing there already). One of several that took the same way may be
// withdrawn only when nobody asks for ways any more.
class Reservation {
  public:
    static constexpr int kBits = 32;
    static constexpr int kCountShift = kDiagonalMoves + 1;
    static constexpr std::uint32_t kOne = 1u << kCountShift;

    static_assert(kMaxTeam << kCountShift <= UINT32_MAX, "a team's number has room");

    explicit constexpr Reservation(std::uint32_t bits) : bits_(bits) {}
    // The way of an agent that moves or stands, in its own turn or in another's; not the agent.
    static Reservation by(int way, bool acts) { return Reservation(acts ? kActing[way] : kStands); }

    int count() const { return static_cast<int>(bits_ >> kCountShift); }
    bool several() const { return bits_ >= 2 * kOne; }
    bool takes(int way) const { return bits_ >> way & 1; }
    bool stands() const { return bits_ & kStands; }
    bool moves() const { return bits_ & kMoves; }
    bool stands_as_actor() const { return bits_ & kStandingActor; }
    constexpr std::uint32_t bits() const { return bits_; }

  private:
    static constexpr std::uint32_t kStands = 1;
    static constexpr std::uint32_t kMoves = (1u << kDiagonalMoves) - 1 - kStands;
    static constexpr std::uint32_t kStandingActor = 1u << kDiagonalMoves;
    static constexpr std::uint32_t kActing[kDiagonalMoves] = {kStands | kStandingActor,
                                                              1u << 1,
                                                              1u << 2,
                                                              1u << 3,
                                                              1u << 4,
                                                              1u << 5,
                                                              1u << 6,
                                                              1u << 7,
                                                              1u << 8};

    std::uint32_t bits_;
};

// Both teams' reservations for every cell, one word a cell. To copy this is to point to the same words.
class ReservationTable {
  public:
    using Word = std::uint64_t;  // the pursuers' reservation in the lower half

    explicit ReservationTable(Word* words) : words_(words) {}

    Reservation at(int cell, Team team) const {
        return Reservation(static_cast<std::uint32_t>(words_[cell] >> shift(team)));
    }
    bool empty(int cell) const { return words_[cell] == 0; }
    // Is one agent, of this team, all that heads for a cell?
    bool alone(int cell, Team team) const { return (words_[cell] & kCounts) == one(team); }
    // Does anybody head for a cell by the opposite of this way? For one that stays, nobody does.
    bool comes_opposite(int cell, int way) const { return words_[cell] & kOppositeMoves[way]; }
    // Is anybody of a team on one of the cells beside this one?
    bool beside(int cell, Team team, const Grid& grid, bool diagonal) const {
        Word around = 0;
        const auto look = [&](int move) { around |= words_[cell + grid.delta(move)]; };
        for (int move = 1; move < kCompassMoves; ++move) look(move);
        for (int move = kCompassMoves; diagonal && move < kDiagonalMoves; ++move) look(move);
        return around & kCounts & of_team(team, Reservation(~0u));
    }

    // Posts one agent, and tells whether anybody is posted there already.
    bool reserve(int cell, Team team, Reservation by) const {
        const Word before = words_[cell];
        words_[cell] = (before + one(team)) | of_team(team, by);
        return before;
    }
    void release(int cell, Team team, int way) const {
        const Word left = words_[cell] - one(team);
        words_[cell] = left & kCounts ? left & ~of_team(team, Reservation(1u << way)) : 0;
    }
    void clear(int cell) const { words_[cell] = 0; }

  private:
    static constexpr int shift(Team team) { return Reservation::kBits * static_cast<int>(team); }
    static constexpr Word of_team(Team team, Reservation reservation) {
        return Word{reservation.bits()} << shift(team);
    }
    static constexpr Word of_both(Reservation reservation) {
        return of_team(Team::Pursuer, reservation) | of_team(Team::Evader, reservation);
    }
    static constexpr Word one(Team team) { return of_team(team, Reservation(Reservation::kOne)); }

    static constexpr Word kCounts =
        ~(Word{Reservation::kOne - 1} << Reservation::kBits | (Reservation::kOne - 1));
    static const std::array<Word, kDiagonalMoves> kOppositeMoves;  // by way; for way 0 nobody

    Word* words_;
};

class Occupancy {
  public:
    // Without `for_networks`, places and boards, which networks look at, are left empty. With
    // `keeps_lists` who stands on a cell is always known; else `list` must be called for it.
    Occupancy(const Grid& grid, int n_pursuers, int n_agents, int fov, bool for_networks,
              bool keeps_lists);

    // Posts an agent that is on no cell; once all are, they occupy.
    void add(int agent, int cell);
    // Takes an agent from the cell that it stands on.
    void remove(int agent, int cell);

    // A turn lifts the agents of its participants, who are all that stand on their cells, posts them in
    // `reservations`, and lets those who are still there (not kGone) occupy. Nobody is lifted where
    // nobody is.
    void release(const std::vector<int>& participants, const IntArray& cell);
    void occupy(const std::vector<int>& participants, const IntArray& cell);
    // Lifts everybody.
    void clear(const std::vector<int>& living, const IntArray& cell);

    ReservationTable reservations() const { return reservations_; }
    int count(int cell, Team team) const { return reservations_.at(cell, team).count(); }
    bool empty(int cell) const { return reservations_.empty(cell); }

    // Makes the lists of who stands where, of everybody; or forgets them. Nothing where they are
    // kept.
    void list(const std::vector<int>& living, const IntArray& cell);
    void unlist();
    const CellLists& lists() const { return lists_; }

    // For networks: who is where, and the boards of the teams where there are more agents than
    // kMaxPositions.
    const PositionTable& position_table() const { return position_table_; }
    const Bitboard& bitboard(Team team) const { return bitboards_[static_cast<int>(team)]; }

    Team team(int agent) const { return agent < n_pursuers_ ? Team::Pursuer : Team::Evader; }

  private:
    void show(int agent, int cell);
    void hide(int agent);
    bool keeps_bitboards() const { return n_agents_ > kMaxPositions; }

    const Grid grid_;
    int n_pursuers_;
    int n_agents_;
    bool for_networks_;
    bool keeps_lists_;
    bool anybody_ = false;
    std::vector<ReservationTable::Word> words_;  // by cell
    ReservationTable reservations_;
    CellLists lists_;
    std::vector<int> listed_;  // cells with a list that was made for this turn
    PositionTable position_table_;
    Bitboard bitboards_[kTeams];
};

}  // namespace matrixworld
