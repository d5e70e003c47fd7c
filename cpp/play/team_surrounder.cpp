#include "play/team_surrounder.hpp"

#include <algorithm>
#include <utility>

#include "observe/near_view.hpp"
#include "observe/search.hpp"

namespace matrixworld {

using namespace near_view;

namespace {

// An event of a probability in 256ths, from eight bits of a draw.
bool happens(std::uint32_t bits, int of_256) { return static_cast<int>(bits & 255) < of_256; }

constexpr int kForbidden = -1000;  // worth less than to stay, whatever that is worth

// ---- Hold --------------------------------------------------------------------------------------

constexpr int kRelease = 128;  // of 256
constexpr int kShift = 8;

// Two adversaries side by side cannot be surrounded. Where they have no side left to part by, their
// holders give way at times. To an open side of another adversary a holder moves on at times, since
// nobody else may reach it, and leaves its own side to those behind.
void rate_as_holder(const NearView& view, std::uint32_t draw, int* worth) {
    const Cells held = view.beside(kMe) & view.adversaries;
    for (Cells rest = held; rest && happens(draw, kRelease);) {
        const Cells adversary = one(take(rest));
        if (!(view.beside(adversary) & view.adversaries) || view.open_sides(adversary)) continue;
        std::fill_n(worth + 1, view.n_actions - 1, 1);
        return;
    }
    for (int move = 1; move < view.n_actions; ++move) {
        worth[move] = kForbidden;
        const Cells others = view.beside(after(move)) & view.adversaries;
        if (!(others & ~held) || (view.beside(others) & view.adversaries)) continue;
        const int gain = count(others) - count(held);
        const int chance = gain > 0 ? 128 : gain == 0 ? kShift : kShift / 4;
        if (happens(draw >> 8, chance)) worth[move] = 1 + count(others);
    }
}

// ---- Allocate ----------------------------------------------------------------------------------

constexpr int kMostAdversaries = 8;  // the nearest ones share
constexpr int kMostRunners = 16;     // the nearest ones, the agent among them
constexpr int kPerMove = 4;          // cost of a move, in which the others are measured
constexpr int kExit = 8;             // cost of the side to which an adversary shall flee,
constexpr int kBehind = 4;           // and gain of the opposite side

// Lists the members of a set that are nearest to the agent, in the order of their numbers, which is
// the same for all that see them.
int list_nearest(const NearView& view, Cells cells, int most, int* out) {
    int n = 0;
    while (cells) out[n++] = take(cells);
    if (n <= most) return n;
    const auto far = [&](int a) { return view.moves({0, 0}, offset(a)) * kSide * kSide + a; };
    std::nth_element(out, out + most, out + n, [&](int a, int b) { return far(a) < far(b); });
    std::sort(out, out + most);
    return most;
}

// The direction in which an adversary shall be driven while it is not yet surrounded: to the
// nearest obstacle or border, beside which fewer pursuers are needed.
int find_exit(const NearView& view, Offset adversary) {
    for (int steps = 1; steps < kSide; ++steps) {
        for (int move = 1; move < kCompassMoves; ++move) {
            const Offset at{adversary.row + kRowStep[move] * steps,
                            adversary.col + kColStep[move] * steps};
            if (fits(at) && (view.blocked & one(number(at)))) return move;
        }
    }
    return 3;  // south: everybody drives it the same way
}

int cost_of_side(const NearView& view, Offset adversary, int exit, Offset runner, Offset side) {
    int moves = view.moves(runner, side);
    // Straight through the adversary there is no way.
    const bool around = view.n_actions == kCompassMoves &&
                        (runner.row - adversary.row) * (side.col - adversary.col) ==
                            (runner.col - adversary.col) * (side.row - adversary.row) &&
                        (runner.row - adversary.row) * (side.row - adversary.row) +
                                (runner.col - adversary.col) * (side.col - adversary.col) <
                            0;
    if (around) moves += 2;
    const bool is_exit =
        side.row == adversary.row + kRowStep[exit] && side.col == adversary.col + kColStep[exit];
    const bool is_behind =
        side.row == adversary.row - kRowStep[exit] && side.col == adversary.col - kColStep[exit];
    return kPerMove * moves + (is_exit ? kExit : 0) - (is_behind ? kBehind : 0);
}

// The side that the agent gets when runners share the sides of an adversary at the least cost, as
// far as exchanges of two lower it; -1 for none.
int share_sides(const NearView& view, int adversary, Cells open, const int* runners,
                int n_runners) {
    const Offset at = offset(adversary);
    const int exit = find_exit(view, at);
    int sides[kDiagonalMoves];
    int n_sides = 0;
    while (open) sides[n_sides++] = take(open);
    int cost[kDiagonalMoves][kDiagonalMoves];  // by place and side; without a runner it is nothing
    for (int i = 0; i < n_sides; ++i) {
        for (int s = 0; s < n_sides; ++s) {
            cost[i][s] = i < n_runners
                             ? cost_of_side(view, at, exit, offset(runners[i]), offset(sides[s]))
                             : 0;
        }
    }
    int side_of[kDiagonalMoves];
    for (int i = 0; i < n_sides; ++i) side_of[i] = i;
    for (bool better = true; better;) {
        better = false;
        for (int i = 0; i < n_sides; ++i) {
            for (int j = 0; j < i; ++j) {
                const int a = side_of[i];
                const int b = side_of[j];
                if (cost[i][b] + cost[j][a] >= cost[i][a] + cost[j][b]) continue;
                std::swap(side_of[i], side_of[j]);
                better = true;
            }
        }
    }
    for (int i = 0; i < n_runners; ++i) {
        if (one(runners[i]) == kMe) return sides[side_of[i]];
    }
    return -1;
}

// The side that is the agent's, or -1. The nearest pair of an adversary with open sides and a
// runner comes first, and so on.
int allocate(const NearView& view, Cells open) {
    int adversaries[kSide * kSide];
    int runners[kSide * kSide];
    const int n_adversaries =
        list_nearest(view, view.beside(open) & view.adversaries, kMostAdversaries, adversaries);
    const int n_runners = list_nearest(view, view.loose | kMe, kMostRunners, runners);
    Cells sides[kMostAdversaries];
    int left[kMostAdversaries];  // sides without a runner
    int members[kMostAdversaries][kDiagonalMoves];
    int n_members[kMostAdversaries] = {};
    for (int a = 0; a < n_adversaries; ++a) {
        sides[a] = view.beside(one(adversaries[a])) & open;
        left[a] = count(sides[a]);
    }
    bool used[kMostRunners] = {};
    int mine = -1;
    for (;;) {
        int best = -1;
        int best_runner = 0;
        int least = 0;
        for (int a = 0; a < n_adversaries; ++a) {
            if (left[a] == 0) continue;
            for (int r = 0; r < n_runners; ++r) {
                if (used[r]) continue;
                const int moves = view.moves(offset(adversaries[a]), offset(runners[r]));
                if (best >= 0 && moves >= least) continue;
                best = a;
                best_runner = r;
                least = moves;
            }
        }
        if (best < 0) break;
        used[best_runner] = true;
        --left[best];
        members[best][n_members[best]++] = runners[best_runner];
        if (one(runners[best_runner]) == kMe) mine = best;
    }
    if (mine < 0) return -1;
    std::sort(members[mine], members[mine] + n_members[mine]);
    return share_sides(view, adversaries[mine], sides[mine], members[mine], n_members[mine]);
}

// ---- Approach ----------------------------------------------------------------------------------

// Rates moves by the way that is left to a side, around obstacles, adversaries and their holders.
// Returns whether there is one in view.
bool rate_way(const NearView& view, int side, int* worth) {
    const Cells free =
        view.seen & ~(view.blocked | view.adversaries | (view.teammates & ~view.loose));
    Cells reached = 0;
    Cells wave = one(side);
    const Cells wanted = (view.beside(kMe) | kMe) & free;
    std::fill_n(worth, view.n_actions, kForbidden);
    for (int moves = 0; wave && (wanted & ~reached); ++moves) {
        reached |= wave;
        for (int move = 0; move < view.n_actions; ++move) {
            if (wave & after(move)) worth[move] = -moves;
        }
        wave = view.beside(wave) & free & ~reached;
    }
    return static_cast<bool>(reached & kMe);
}

}  // namespace

void rate_for_team(const World& world, const Sight& sight, int agent, std::uint32_t draw,
                   int* worth) {
    const NearView view(world, sight);
    std::fill_n(worth, view.n_actions, 0);
    if (view.beside(kMe) & view.adversaries) return rate_as_holder(view, draw, worth);

    // The last way out of an adversary beside another one stays open, so that they can part.
    const Cells paired = view.adversaries & view.beside(view.adversaries);
    Cells shut = 0;
    for (Cells rest = paired; rest;) {
        const Cells sides = view.open_sides(one(take(rest)));
        if (count(sides) == 1) shut |= sides;
    }
    shut &= ~view.beside(view.adversaries & ~paired);

    constexpr int kDrift = 128;  // of 256
    const Cells open = view.open_sides(view.adversaries) & view.seen & ~shut;
    const int side = open ? allocate(view, open) : -1;
    if (side < 0 || !rate_way(view, side, worth)) {
        std::fill_n(worth, view.n_actions, 0);
        if (open && happens(draw, kDrift)) {
            std::fill_n(worth + 1, view.n_actions - 1, 1);  // makes room
        } else {
            rate_search(world, view, agent, worth);
        }
    }
    for (int move = 1; move < view.n_actions; ++move) {
        if (shut & after(move)) worth[move] = 2 * kForbidden;
    }
}

}  // namespace matrixworld
