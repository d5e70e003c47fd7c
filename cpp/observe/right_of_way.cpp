#include "observe/right_of_way.hpp"

#include <algorithm>

namespace matrixworld {

namespace {

// May an agent of the team enter the cell of an adversary that stays there? Under capture by
// surrounding whoever moves into a contact is at fault; otherwise only an agent that is held is (as
// `holds` in resolve.cpp says).
bool contact_is_safe(const Rules& rules, Team team) {
    const Outcome own = rules.adversary(team), foreign = rules.adversary(opponent(team));
    const bool held = bounces(own) || (own == Outcome::Reach && bounces(foreign));
    return rules.capture == Capture::Occupation && !held;
}

// May an agent of the team enter a cell that an adversary enters, too? If the adversary is held, it
// alone is at fault.
bool meeting_is_safe(const Rules& rules, Team team) {
    const bool held = bounces(rules.adversary(team));
    const bool only_adversary_held = bounces(rules.adversary(opponent(team)));
    return !held && (rules.capture == Capture::Occupation || only_adversary_held);
}

// Can an adversary that enters the same cell put the team at fault? In turns it enters before or
// afterwards: all pursuers take theirs before the evaders.
bool must_yield_to_adversaries(const Rules& rules, Team team) {
    if (rules.interaction == Interaction::Simultaneous) return !meeting_is_safe(rules, team);
    return team == Team::Evader && !contact_is_safe(rules, team);
}

}  // namespace

// Directions clockwise from north: the compass moves first, then the diagonal ones between them.
bool goes_first(int move, int other) {
    constexpr int kEighth[kDiagonalMoves] = {0, 0, 2, 4, 6, 1, 3, 5, 7};
    const int apart = (kEighth[other] - kEighth[move] + 8) % 8;
    return apart == 4 ? move < other : apart != 0 && apart < 4;
}

RightOfWay::RightOfWay(const Config& config, Team team) {
    const Rules& rules = config.rules;
    const int own = channel(team), foreign = channel(opponent(team));
    const bool yields = must_yield_to_adversaries(rules, team);
    const int n_moves = config.n_actions();
    const auto list = [&](int move, const auto& first) {
        const int row = kRowStep[move], col = kColStep[move];
        std::vector<Cell> cells = {{kObstacles, row, col}, {own, row, col}};
        if (!contact_is_safe(rules, team)) cells.push_back({foreign, row, col});
        for (int other = 1; other < n_moves; ++other) {
            const int from_row = row - kRowStep[other], from_col = col - kColStep[other];
            if (first(other, move)) cells.push_back({own, from_row, from_col});
            // An adversary may be on the own cell, from where it could make the same move.
            if (yields) cells.push_back({foreign, from_row, from_col});
        }
        return cells;
    };
    for (int move = 1; move < n_moves; ++move) {
        forbidding_[move] = list(move, goes_first);
        for (int order = 0; order < kOrders; ++order) {
            const auto place = [&](int m) { return (m + order) % (n_moves - 1); };
            forbidding_in_turn_[order][move] =
                list(move, [&](int m, int other) { return place(m) < place(other); });
        }
    }
}

bool RightOfWay::allows(const World& world, const Occupancy& occupancy, int agent, int move) const {
    const Grid& grid = world.grid();
    const int row = grid.row(world.cell(agent)), col = grid.col(world.cell(agent));
    const auto is_set = [&](const Cell& seen) {
        const int r = row + seen.row, c = col + seen.col;
        if (r < 0 || r >= grid.rows() || c < 0 || c >= grid.cols()) {
            return seen.channel == kObstacles;
        }
        const int cell = grid.cell(r, c);
        if (seen.channel == kObstacles) return world.terrain().kind[cell] != kFree;
        const Team team = seen.channel == kPursuers ? Team::Pursuer : Team::Evader;
        return occupancy.count(cell, team) > 0;
    };
    const std::vector<Cell>& cells = forbidding(order(world.steps()), move);
    return std::none_of(cells.begin(), cells.end(), is_set);
}

}  // namespace matrixworld
