// What is read and written when an agent looks at its moves (`MoveInputs`). Plain data only, as positions.hpp:
// kernels.cpp includes this file.
#pragma once

#include <cstddef>
#include <cstdint>

#include "grid/positions.hpp"

namespace matrixworld {

// Numbers of all moves: a lane for each, in whole vectors. Five moves take half of them.
constexpr int kMoveLanes = 16;

// Cells at most kNear rows and columns from an agent, row by row: what lies there may forbid a move.
constexpr int kNear = 2;
constexpr int kNearSide = 2 * kNear + 1;
constexpr int kNearCells = kNearSide * kNearSide;

// The named inputs; `input_texts` says what they are.
enum Input : int {
    kAdversary,
    kPressure,
    kUnclaimed,
    kOpenSide,
    kTeammate,
    kExits,
    kRoom,
    kMustYield,
    kAhead,
    kSearch,
    kInputs
};

// The inputs of an agent's moves. Moves are bits of `blocked`, those into an obstacle, and of
// `forbidden`, those that right of way forbids.
struct alignas(64) MoveRows {
    float of[kInputs][kMoveLanes];
    std::uint32_t blocked;
    std::uint32_t forbidden;
};

// A cell of the view.
struct alignas(64) SeenCell {
    float moves[kMoveLanes];  // from the cell of each move
    float
        charge[kMoveLanes];  // 1 / (1 + moves)^2, rounded down so that sums are exact in any order
    int row;                 // from the agent
    int col;
    int place;  // in MoveLook::taken
    int near;   // place among the near cells; kNearCells if it is none
};

// Cells on which an agent sees a team.
struct SeenCells {
    const SeenCell* const* cells;
    int n;
};

struct MoveLook {
    static constexpr std::uint64_t kOutOfView = ~std::uint64_t{0};
    struct Step {
        int row;
        int col;
        int place;
    };

    // Of a configuration.
    int fov;
    int n_moves;
    bool diagonal;
    float unit;            // 1 / half a view
    const SeenCell* view;  // by cell of the view
    const Step* steps;     // by move
    // By cell of the view and one around it: the number of the look that found a teammate there.
    std::uint64_t* taken;

    // Of the inputs that are wanted.
    bool asks_claims;
    bool asks_sides;

    // Of a moment; without positions (0 agents) the seen cells are given.
    Positions positions;

    // Of an agent. Teams are its own and the other one.
    int place;                        // among the positions
    int first[2];                     // by team: place of its channel in the flattened view
    const std::uint64_t* of_team[2];  // by team: its agents, as bits
    const std::uint8_t* walls;        // around its cell
    std::ptrdiff_t walls_stride;
    const std::uint16_t (*forbids)[kNearCells + 1];  // by team and near cell; behind them 0
    std::uint64_t number;                            // of this look

    MoveRows* rows;  // what is written
};

}  // namespace matrixworld
