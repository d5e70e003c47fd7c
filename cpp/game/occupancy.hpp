// The reservation table: for each cell, which agents have reserved it for the turn. (Reservation
// tables come from multi-agent path finding: Silver 2005, "Cooperative pathfinding".) With it,
// whether an agent is in conflict takes a look at two words, those of the cell it enters and of the
// cell it leaves. Comparing all pairs of agents would cost O(agents^2).
//
// One table serves all the worlds that a thread plays, so its size does not grow with their number.
// A world enters its agents, is played and observed, and leaves. Every operation costs O(1) an
// agent, whatever the size of the grid: cells are never cleared as a whole.
//
//     Occupancy occupancy(grid, n_pursuers, n_agents, fov, true, false);
//     for (int a : living) occupancy.add(a, cell[a]);
//     occupancy.occupy(living, cell);                   // each agent has reserved its own cell
//
//     occupancy.release(living, cell);                  // a turn: give up those reservations,
//     ReservationTable table = occupancy.reservations();
//     table.reserve(target, team, Reservation::of(move, true));  // reserve targets, judge them,
//     occupancy.occupy(living, cell);                   // publish the new positions
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grid/agent_lists.hpp"
#include "grid/bitboard.hpp"
#include "grid/grid.hpp"
#include "grid/position_table.hpp"

namespace matrixworld {

// The reservations of one cell by the agents of one team: how many, and by which of the nine moves
// they come (move 0: the agent is on the cell already). The bits say that some agent comes by a
// move, not how many do: when one of several with the same move is released, the bit is cleared for
// all of them. Release such agents only when the moves are read no more.
class Reservation {
  public:
    static constexpr int kBits = 32;
    static constexpr int kCountShift = kDiagonalMoves + 1;
    static constexpr std::uint32_t kOne = 1u << kCountShift;

    static_assert(std::uint64_t{kMaxTeam} << kCountShift <= UINT32_MAX,
                  "the count of a whole team fits");

    explicit constexpr Reservation(std::uint32_t bits) : bits_(bits) {}
    // The bits, without the count, of an agent that makes this move; `acts` says whether it is one
    // of the actors of the turn. An agent that does not act stays.
    static Reservation of(int move, bool acts) {
        return Reservation(acts ? kActing[move] : kStanding);
    }

    int count() const { return static_cast<int>(bits_ >> kCountShift); }
    bool several() const { return bits_ >= 2 * kOne; }
    bool has_move(int move) const { return bits_ >> move & 1; }
    bool has_standing() const { return bits_ & kStanding; }
    bool has_moving() const { return bits_ & kMoving; }
    bool has_standing_actor() const { return bits_ & kStandingActor; }
    constexpr std::uint32_t bits() const { return bits_; }

  private:
    static constexpr std::uint32_t kStanding = 1;
    static constexpr std::uint32_t kMoving = (1u << kDiagonalMoves) - 1 - kStanding;
    // Two agents are in conflict only when one of them acts. Where neither moves, this bit tells.
    static constexpr std::uint32_t kStandingActor = 1u << kDiagonalMoves;
    static constexpr std::uint32_t kActing[kDiagonalMoves] = {kStanding | kStandingActor,
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

// The reservations of both teams for every cell, one 64-bit word a cell. A copy refers to the same
// words; loops take one by value so that the compiler keeps its pointer in a register.
class ReservationTable {
  public:
    using Word = std::uint64_t;  // the pursuers' reservation in the lower half

    explicit ReservationTable(Word* words) : words_(words) {}

    Reservation at(int cell, Team team) const {
        return Reservation(static_cast<std::uint32_t>(words_[cell] >> shift(team)));
    }
    bool empty(int cell) const { return words_[cell] == 0; }
    // Is the cell reserved by one agent only, and is it of this team?
    bool only_one(int cell, Team team) const { return (words_[cell] & kCounts) == one(team); }
    // Is the cell reserved by an agent that comes by the opposite of this move? Two agents swap
    // their cells only then. False for move 0.
    bool has_opposite(int cell, int move) const { return words_[cell] & kOppositeMoves[move]; }
    // Is any of the neighbour cells (4, or 8 with `diagonal`) reserved by this team?
    bool any_beside(int cell, Team team, const Grid& grid, bool diagonal) const {
        Word around = 0;
        const auto add = [&](int move) { around |= words_[cell + grid.delta(move)]; };
        for (int move = 1; move < kCompassMoves; ++move) add(move);
        for (int move = kCompassMoves; diagonal && move < kDiagonalMoves; ++move) add(move);
        return around & kCounts & of_team(team, Reservation(~0u));
    }

    // Reserves a cell for one agent. Returns whether the cell was reserved before.
    bool reserve(int cell, Team team, Reservation added) const {
        const Word before = words_[cell];
        words_[cell] = (before + one(team)) | of_team(team, added);
        return before;
    }
    // Gives up the reservation of one agent that comes by this move. When it was the last, the word
    // becomes 0, so that an empty table is all zeros and is never cleared as a whole.
    void release(int cell, Team team, int move) const {
        const Word left = words_[cell] - one(team);
        words_[cell] = left & kCounts ? left & ~of_team(team, Reservation(1u << move)) : 0;
    }
    // Gives up all reservations of a cell.
    void clear(int cell) const { words_[cell] = 0; }

  private:
    static constexpr int shift(Team team) { return Reservation::kBits * static_cast<int>(team); }
    static constexpr Word of_team(Team team, Reservation reservation) {
        return Word{reservation.bits()} << shift(team);
    }
    static constexpr Word one(Team team) { return of_team(team, Reservation(Reservation::kOne)); }

    static constexpr Word kCounts =
        ~(Word{Reservation::kOne - 1} << Reservation::kBits | (Reservation::kOne - 1));
    static const std::array<Word, kDiagonalMoves> kOppositeMoves;  // by move; 0 for move 0

    Word* words_;
};

// The reservation table of a thread, with everything else that is kept by cell or position.
class Occupancy {
  public:
    // `for_networks`: keep the position table and the bitboards, which networks and inputs of moves
    // read; without it
    // they stay empty. `keeps_lists`: keep the lists of agents by cell at all times; without it
    // `make_lists` must be called before they are read.
    Occupancy(const Grid& grid, int n_pursuers, int n_agents, int fov, bool for_networks,
              bool keeps_lists);

    // Reserves for an agent the cell on which it is. Precondition: the agent has no reservation.
    // After all agents are added, `occupy` must be called.
    void add(int agent, int cell);
    // Removes an agent from its cell, between `occupy` and the next `release`.
    void remove(int agent, int cell);

    // Gives up the reservations of the participants of a turn. Precondition: no other agent is on
    // their cells. Does nothing when no agent was added, so that a world whose turns affect all its
    // agents may be played without entering before.
    void release(const std::vector<int>& participants, const IntArray& cell);
    // Publishes the positions after a turn to the lists, the position table and the bitboards.
    // Precondition: the participants that are left (cell not kGone) have reserved their cells.
    void occupy(const std::vector<int>& participants, const IntArray& cell);
    // Gives up all reservations: the occupancy is empty, ready for another world.
    void clear(const std::vector<int>& living, const IntArray& cell);

    ReservationTable reservations() const { return reservations_; }
    int count(int cell, Team team) const { return reservations_.at(cell, team).count(); }
    bool empty(int cell) const { return reservations_.empty(cell); }

    // Makes the lists of agents by cell, at most once a turn, and forgets them. Few turns need
    // them where all agents act together. Both do nothing where the lists are kept.
    void make_lists(const std::vector<int>& living, const IntArray& cell);
    void clear_lists();
    const CellLists& lists() const { return lists_; }

    // For networks: the positions of all agents; and where there are more than kMaxPositions of
    // them, a bitboard of each team.
    const PositionTable& position_table() const { return position_table_; }
    const Bitboard& bitboard(Team team) const { return bitboards_[static_cast<int>(team)]; }

    Team team(int agent) const { return agent < n_pursuers_ ? Team::Pursuer : Team::Evader; }

  private:
    void set_position(int agent, int cell);
    void clear_position(int agent);
    bool keeps_bitboards() const { return n_agents_ > kMaxPositions; }

    const Grid grid_;
    int n_pursuers_;
    int n_agents_;
    bool for_networks_;
    bool keeps_lists_;
    bool in_use_ = false;                        // a world has entered its agents
    std::vector<ReservationTable::Word> words_;  // by cell
    ReservationTable reservations_;
    CellLists lists_;
    std::vector<int> listed_;  // cells whose lists were made for this turn
    PositionTable position_table_;
    Bitboard bitboards_[kTeams];
};

}  // namespace matrixworld
