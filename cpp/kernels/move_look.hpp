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
    kEscapes,
    kOpposed,
    kParity,
    kInputs
};

// The inputs of an agent's moves. Moves are bits of `blocked`, those into an obstacle, and of
// `forbidden`, those that right of way forbids.
struct alignas(64) MoveRows {
    float of[kInputs][kMoveLanes];
    std::uint32_t blocked;
    std::uint32_t forbidden;
};

// A layer of a network that rates moves, and numbers of some agents. Rows have kMoveLanes numbers.
struct MoveLayer {
    int n_moves;
    int n_in;
    int n_units;
    const int* rows;       // of `in`, by input of the layer
    const float* weights;  // (n_in, n_units)
    const float* biases;   // null: zeros
    float least;           // of the results

    int n_agents;
    const float* in;  // of the first agent; those of the next one begin in_stride behind it
    std::ptrdiff_t in_stride;
    float* out;  // (n_units, kMoveLanes)
    std::ptrdiff_t out_stride;
};

// A cell of the view.
struct alignas(64) SeenCell {
    float moves[kMoveLanes];  // from the cell of each move
    float
        charge[kMoveLanes];  // 1 / (1 + moves)^2, rounded down so that sums are exact in any order
    int cell;                // in the grid, from the agent's
    int index;               // in MoveLook::view
    int spot;                // in MoveLook::apart
    int near;                // place among the near cells; kNearCells if it is none
    std::uint32_t unseen;    // the cells of its moves that are out of view, as bits
};

// The cell of a move of the agent.
struct Step {
    int cell;
    int spot;
    int index;  // in MoveLook::view
    std::uint32_t unseen;
};

// What a cell is to another one.
struct Apart {
    int moves;
    std::uint32_t
        reached;  // the cells of the other's moves that are at most one move from it, as bits
    float row;    // direction from the other, of length 1; zeros on the same cell
    float col;
};

// Cells on which an agent sees a team.
struct SeenCells {
    const SeenCell* const* cells;
    int n;
};

struct MoveLook {
    // Of a configuration.
    int fov;
    int n_moves;
    float unit;            // 1 / half a view
    const SeenCell* view;  // by cell of the view
    const Step* steps;     // by move
    const Apart* apart;    // by difference of the spots of two cells
    const float* shares;   // n / n_moves, by n
    const float* exits;    // by open moves, as bits
    // By cell of the view: the number of the look that found a teammate there.
    std::uint64_t* taken;

    std::uint32_t wanted;  // inputs, as bits

    // Of a moment; without positions (0 agents) the seen cells are given.
    Positions positions;
    int n_pursuers;  // the first of the positions

    // Of an agent. Teams are its own and the other one.
    bool pursues;
    int place;                  // among the positions
    const std::uint16_t* open;  // from its cell: which moves lead to no obstacle, as bits
    const std::uint8_t* room;   // from its cell, in cells
    std::uint32_t ahead;        // the direction of its stride, as bits
    std::uint32_t search;       // moves along its way of searching, as bits
    const std::uint16_t (*forbids)[kNearCells + 1];  // by team and near cell; behind them 0
    std::uint64_t number;                            // of this look

    MoveRows* rows;  // what is written
};

}  // namespace matrixworld
