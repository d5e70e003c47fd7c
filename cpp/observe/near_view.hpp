// What an agent sees of the cells around it as sets of cells, which are bits: a move shifts a set, and
// the free sides of all adversaries are one expression.
//
//     const NearView view(world, sight);
//     Cells open = view.open_sides(view.adversaries);
//     while (open) visit(offset(take(open)));
#pragma once

#include <algorithm>
#include <cstdlib>

#include "grid/compiler.hpp"
#include "observe/sight.hpp"

namespace matrixworld::near_view {

// ---- Sets of cells -----------------------------------------------------------------------------

// A set of cells around the agent, which is in the middle: at most 11 x 11, also of a wider view.
using Cells = Bits128;
constexpr int kSide = 11;
constexpr int kReach = kSide / 2;

constexpr int number(Offset at) { return (at.row + kReach) * kSide + at.col + kReach; }
constexpr Offset offset(int number) { return {number / kSide - kReach, number % kSide - kReach}; }
constexpr bool fits(Offset at) {
    return -kReach <= at.row && at.row <= kReach && -kReach <= at.col && at.col <= kReach;
}
constexpr Cells one(int number) { return Cells{1} << number; }
constexpr Offset step(int move, int steps = 1) {
    return {kRowStep[move] * steps, kColStep[move] * steps};
}
constexpr Cells after(int move) { return one(number(step(move))); }
constexpr Cells kMe = one(number({0, 0}));
constexpr Cells kAll = one(kSide * kSide) - 1;

constexpr Cells column(int col) {
    Cells cells = 0;
    for (int row = -kReach; row <= kReach; ++row) cells |= one(number({row, col}));
    return cells;
}
constexpr Cells kWest = column(-kReach);
constexpr Cells kEast = column(kReach);

inline int count(Cells cells) { return count_bits(lower(cells)) + count_bits(upper(cells)); }

// Removes the first cell of a set and returns its number.
inline int take(Cells& cells) {
    const int first = lower(cells) ? lowest_bit(lower(cells)) : 64 + lowest_bit(upper(cells));
    cells &= cells - 1;
    return first;
}

inline Cells moved(Cells cells, int move) {
    if (kColStep[move] > 0) cells = (cells & ~kEast) << 1;
    if (kColStep[move] < 0) cells = (cells & ~kWest) >> 1;
    if (kRowStep[move] > 0) cells = cells << kSide & kAll;
    if (kRowStep[move] < 0) cells >>= kSide;
    return cells;
}

// ---- What an agent sees ------------------------------------------------------------------------

struct NearView {
    NearView(const World& world, const Sight& sight)
        : n_actions(world.config().n_actions()), reach(std::min(world.config().fov / 2, kReach)) {
        for (Offset at : sight.adversaries()) {
            if (fits(at)) adversaries |= one(number(at));
        }
        for (Offset at : sight.teammates()) {
            if (fits(at)) teammates |= one(number(at));
        }
        teammates &= ~kMe;  // who shares the agent's cell tells it nothing
        for (int row = -reach; row <= reach; ++row) {
            for (int col = -reach; col <= reach; ++col) {
                seen |= one(number({row, col}));
                if (sight.is_blocked({row, col})) blocked |= one(number({row, col}));
            }
        }
        loose = teammates & ~beside(adversaries);
    }

    Cells beside(Cells cells) const {
        Cells all = 0;
        for (int move = 1; move < n_actions; ++move) all |= moved(cells, move);
        return all;
    }
    // The sides of an adversary that are neither obstacles nor held by anybody.
    Cells open_sides(Cells adversary) const {
        return beside(adversary) & ~(blocked | adversaries | teammates | kMe);
    }
    // Is the border, or a wall at least three cells wide, so many steps away?
    bool is_border(int move, int steps) const {
        const Cells there = one(number(step(move, steps)));
        const int aside = move % 4 + 1;
        return !((there | moved(there, aside) | moved(there, kOpposite[aside])) & ~blocked);
    }
    int moves(Offset from, Offset to) const {
        const int rows = std::abs(from.row - to.row);
        const int cols = std::abs(from.col - to.col);
        return n_actions > kCompassMoves ? std::max(rows, cols) : rows + cols;
    }

    int n_actions;
    int reach;
    Cells adversaries = 0;
    Cells teammates = 0;
    Cells blocked = 0;
    Cells seen = 0;
    Cells loose = 0;  // teammates that hold no adversary
};

}  // namespace matrixworld::near_view
