// Who heads for each cell: scratch memory of one thread, shared by all the worlds that it plays.
// Between two turns everybody heads for where it stands; a turn lifts its agents and posts them
// where they mean to go, and whoever must not go there is withdrawn and posted elsewhere. A world
// puts its agents in, is played and looked at, and takes them out again; every operation costs
// O(1) an agent, whatever the size of the grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "board.hpp"
#include "cell_lists.hpp"
#include "grid.hpp"

namespace matrixworld {

// The agents of one team that head for a cell: how many, and which of the nine ways to get there
// are taken (way 0: by standing there already). One of several that took the same way may be
// withdrawn only when nobody asks for ways any more.
class Heading {
  public:
    static constexpr int kBits = 32;

    explicit constexpr Heading(std::uint32_t bits) : bits_(bits) {}
    // The way of an agent that moves or stands, in its own turn or in another's; not the agent.
    static constexpr Heading by(int way, bool acts) {
        return Heading(1u << way | (way == 0 && acts ? kStandingActor : 0));
    }

    int count() const { return static_cast<int>(bits_ >> kCountShift); }
    bool several() const { return bits_ >= 2 * kOne; }
    bool takes(int way) const { return bits_ >> way & 1; }
    bool stands() const { return bits_ & kStands; }
    bool moves() const { return bits_ & kMoves; }
    bool stands_as_actor() const { return bits_ & kStandingActor; }
    constexpr std::uint32_t bits() const { return bits_; }

    static constexpr int kCountShift = kDiagonalMoves + 1;
    static constexpr std::uint32_t kOne = 1u << kCountShift;

  private:
    static constexpr std::uint32_t kStands = 1;
    static constexpr std::uint32_t kMoves = (1u << kDiagonalMoves) - 1 - kStands;
    static constexpr std::uint32_t kStandingActor = 1u << kDiagonalMoves;

    std::uint32_t bits_;
};

// Both teams' headings for a cell, the pursuers' in the lower half.
namespace cell_word {

using Word = std::uint64_t;

constexpr int shift(Team team) { return Heading::kBits * static_cast<int>(team); }
constexpr Word of_team(Team team, Heading heading) { return Word{heading.bits()} << shift(team); }
constexpr Word of_both(Heading heading) {
    return of_team(Team::Pursuer, heading) | of_team(Team::Evader, heading);
}

constexpr Word one(Team team) { return of_team(team, Heading(Heading::kOne)); }
constexpr Word kCounts = ~of_both(Heading(Heading::kOne - 1));

// By way: whoever comes the opposite way; nobody for one that stays.
constexpr std::array<Word, kDiagonalMoves> opposite_ways() {
    std::array<Word, kDiagonalMoves> words{};
    for (int way = 1; way < kDiagonalMoves; ++way) words[way] = of_both(Heading(1u << kOpposite[way]));
    return words;
}
constexpr std::array<Word, kDiagonalMoves> kOppositeWays = opposite_ways();

}  // namespace cell_word

class Occupancy {
  public:
    // Without `for_networks`, rows, cols and boards, which networks look at, are left empty. With
    // `keeps_lists` who stands on a cell is always known; else `list` must be called for it.
    Occupancy(const Grid& grid, int n_pursuers, int n_agents, int margin, bool for_networks,
              bool keeps_lists);

    // Lets an agent that is on no cell stand on one.
    void add(int agent, int cell);
    // Takes an agent from the cell that it stands on.
    void remove(int agent, int cell);

    // A turn: lifts the agents of a cast, who are all that stand on their cells, posts them or
    // withdraws them from where they were posted, and lets those still there (not kGone) land.
    void lift(const std::vector<int>& cast, const IntArray& cell);
    void post(Team team, int cell, Heading news) {
        Word& word = words_[cell];
        word = (word + cell_word::one(team)) | cell_word::of_team(team, news);
    }
    void withdraw(Team team, int cell, int way);
    void land(const std::vector<int>& cast, const IntArray& cell);

    Heading heading(int cell, Team team) const {
        return Heading(static_cast<std::uint32_t>(words_[cell] >> cell_word::shift(team)));
    }
    // Does anybody else head for the cell that an agent heads for, or come from there to the cell
    // that it leaves?
    bool meets(Team team, int target, int cell, int way) const;

    int count(int cell, Team team) const { return heading(cell, team).count(); }
    bool empty(int cell) const { return words_[cell] == 0; }
    const Board& board(Team team) const { return boards_[static_cast<int>(team)]; }

    // Makes the lists of who stands where, of everybody; or forgets them. Nothing where they are
    // kept.
    void list(const std::vector<int>& living, const IntArray& cell);
    void unlist();
    const CellLists& lists() const { return lists_; }

    // Row and column by agent, with room for a multiple of kPlacePad; far off when not here.
    const std::int16_t* rows() const { return rows_.data(); }
    const std::int16_t* cols() const { return cols_.data(); }
    int n_agents() const { return n_agents_; }

    // Up to so many agents, looking at the place of each costs less than reading the boards.
    static constexpr int kFewAgents = 128;

    Team team(int agent) const { return agent < n_pursuers_ ? Team::Pursuer : Team::Evader; }

  private:
    using Word = cell_word::Word;

    void show(int agent, int cell);
    void hide(int agent);
    bool keeps_boards() const { return n_agents_ > kFewAgents; }

    const Grid grid_;
    int n_pursuers_;
    int n_agents_;
    bool for_networks_;
    bool keeps_lists_;
    Eigen::Array<Word, Eigen::Dynamic, 1> words_;  // by cell
    CellLists lists_;
    std::vector<int> listed_;  // cells with a list that was made for this turn
    std::vector<std::int16_t> rows_;
    std::vector<std::int16_t> cols_;
    Board boards_[kTeams];
};

inline bool Occupancy::meets(Team team, int target, int cell, int way) const {
    const bool alone = (words_[target] & cell_word::kCounts) == cell_word::one(team);
    return !alone | ((words_[cell] & cell_word::kOppositeWays[way]) != 0);
}

}  // namespace matrixworld
