// The right of way: which moves of an agent can never put it at fault, as long as all agents of its
// team keep to them. An agent decides by its own view. A move into a cell is allowed if
//
//   - the cell is free: no obstacle, no teammate, and no adversary unless contact holds nobody of
//     the own team;
//   - no teammate that could enter the cell in this step goes first;
//   - no adversary could enter it, where a meeting there would put the own team at fault.
//
// In a fixed order an agent that stays where it is may bar a cell for ever to those that would have
// to let it go first. Networks keep to one, because their weights are fixed: right before left.
// Scripts know the step, and the order changes with it: each move is first in its turn.
//
// Staying is always allowed. Two agents that can enter one cell are at most two moves apart, so each
// sees the other in a view of `kLeastFov`, and exactly one of them goes first. So no two teammates
// ever enter one cell, and nobody enters a cell that is taken. Where the rules take turns, this holds
// for agents that decide when their turn begins, and for agents that decide before the round.
//
//     const RightOfWay ways(config, Team::Pursuer);
//     if (ways.allows(world, occupancy, agent, move)) ...
#pragma once

#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"

namespace matrixworld {

class RightOfWay {
  public:
    static constexpr int kLeastFov = 5;
    static constexpr int kOrders = kDiagonalMoves - 1;

    // A cell relative to an agent. What is seen there forbids a move: an agent of a team, or an
    // obstacle.
    struct Cell {
        int channel;
        int row;
        int col;
    };

    RightOfWay(const Config& config, Team team);

    // What forbids a move; nothing forbids to stay.
    const std::vector<Cell>& forbidding(int move) const { return forbidding_[move]; }
    // The same in one of the orders, of which each step has one.
    const std::vector<Cell>& forbidding(int order, int move) const {
        return forbidding_in_turn_[order][move];
    }
    // One order more after each round of them, so that no agents fall into step with the orders.
    static int order(int step) { return (step + step / kOrders) % kOrders; }
    // In the order of this step. Precondition: the world has entered the occupancy.
    bool allows(const World& world, const Occupancy& occupancy, int agent, int move) const;

  private:
    std::vector<Cell> forbidding_[kDiagonalMoves];
    std::vector<Cell> forbidding_in_turn_[kOrders][kDiagonalMoves];  // by order, which is by step
};

// Does an agent that enters a cell by one move go before a teammate that enters it by another one?
// Right before left, as on a road; of two that face each other, the one that moves by the smaller
// number.
bool goes_first(int move, int other);

}  // namespace matrixworld
