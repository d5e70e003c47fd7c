// The inner loops of networks and views, compiled once for each instruction set (kernels.cpp) and
// chosen when the program runs. Every level gives the same bits, so results do not depend on the
// processor: every sum has one fixed order and its own vector lane (adding across lanes would
// depend on their number), each product is added by a fused multiply-add (rounded once, also where
// it takes a library call), and the exponential is our own (libraries differ in the last bit).
//
//     kernels().dense(in, in_stride, n, n_in, weights, bias, width, n_out, Activation::Relu, out);
#pragma once

#include <cstdint>

#include "grid/positions.hpp"
#include "kernels/move_look.hpp"

namespace matrixworld {

enum class Activation : std::uint8_t { None, Relu, Tanh };

// The recurrent layer of a network: none, or gated recurrent units (Cho et al. 2014).
enum class Memory : std::uint8_t { None, Gru };

constexpr int kGates = 3;  // sums of products for each gated unit: the gates r and z, the candidate

// Layers are padded in memory to a multiple of this many floats: the widest vector. Rows (agents)
// are padded to a multiple of kRowPad. So kernels need no code for the rest of a layer.
constexpr int kPad = 16;
constexpr int kRowPad = 8;

inline int padded(int n) { return (n + kPad - 1) / kPad * kPad; }

struct Kernels {
    const char* level;  // the name of the instruction set

    // Write n_views views, (n_views, 3, fov, fov), 0 or 1, channels evaders, pursuers, obstacles. That
    // of the agent in place i of the positions has the number agents[i], and its obstacle channel is
    // copied from obstacles[i]: fov rows of fov bytes, `stride` bytes apart. The others are zeros.
    void (*write_byte_views)(const Positions& positions, const int* agents, int n_views,
                             const std::uint8_t* const* obstacles, int stride, std::uint8_t* views);
    void (*write_float_views)(const Positions& positions, const int* agents, int n_views,
                              const std::uint8_t* const* obstacles, int stride, float* views);

    // Writes the wanted inputs of an agent's moves, and the moves that obstacles and other agents
    // forbid. Given cells count only without positions.
    void (*look_at_moves)(const MoveLook& look, SeenCells teammates, SeenCells adversaries);

    // A layer of a network that rates moves, of some agents: out[unit, move] = max(least,
    // biases[unit] + the sum of weights[i, unit] * in[rows[i], move]), for i < n_in in this order,
    // with rounded products; what is no number becomes `least`.
    void (*rate_moves)(const MoveLayer& layer);

    // The first layer of a network, whose input (a view) is nearly all zeros:
    // out[i, 0..width) = activation(bases[i] + the sum of the rows of `weights` for the cells that
    // other agents set in the view of agents[i]), for i < n. Each cell is added once, in ascending
    // order of the agents. Preconditions: at most kMaxPositions agents; width a multiple of kPad.
    void (*sum_seen)(const Positions& positions, const int* agents, int n,
                     const float* const* bases, const float* weights, int width,
                     Activation activation, float* out);

    // out[0..width) = activation(base + the sum of the given rows of `weights`, in their order).
    // Precondition: width is a multiple of kPad.
    void (*sum_rows)(const float* base, const float* weights, int stride, const int* rows, int n,
                     int width, Activation activation, float* out);

    // out[0..width) = base + the sum of the rows of `weights` whose bits are set in `words`, in their
    // order: bit i of word w is row 64 w + i. Precondition: width is a multiple of kPad.
    void (*sum_bits)(const float* base, const float* weights, const std::uint64_t* words,
                     int n_words, int width, float* out);

    // out[i, 0..width) = activation(bias + in[i, :] weights) for i < n; `weights` is
    // (n_in, width), `in` has `in_stride` and `out` `width` floats a row, and both have room for a
    // multiple of kRowPad rows. Only the first n_out of each row of `out` are valid.
    void (*dense)(const float* in, int in_stride, int n, int n_in, const float* weights,
                  const float* bias, int width, int n_out, Activation activation, float* out);

    // A recurrent layer of n_units: out[i, :] = what agent i remembers next, from its input in[i, :]
    // and what it remembers, states[i, :], for i < n. `weights` has 2 n_units rows, first those of the
    // inputs, each of kGates columns for each unit: the first kPad units' columns of every
    // gate, then those of the next kPad units. `bias` is such a row. Rows of `in` have `in_stride`
    // floats, those of `states` and `out` padded(n_units), and all have room for a multiple of kRowPad
    // rows. The formulas are in Python's `Network`; each sum adds the bias, the products of the inputs
    // and those of the state in this order; those of the state for a candidate are a sum of their own.
    void (*remember)(const float* in, int in_stride, const float* states, int n, int n_units,
                     const float* weights, const float* bias, float* out);

    // Draws actions[i] from softmax(logits[i, 0..n_actions)) by inverting the distribution at
    // units[i] in [0, 1). Without units (null) it is the largest logit, the first of equal ones.
    void (*choose)(const float* logits, int stride, int n, int n_actions, const float* units,
                   std::uint8_t* actions);

    // The last layer and `choose` in one pass, for n rows of `in` as `dense` reads them and 5 or 9
    // actions. `in`, `units` and `actions` have room for a multiple of kPad rows, and rows of `in`
    // for a multiple of kPad numbers.
    void (*finish)(const float* in, int in_stride, int n, int n_in, const float* weights,
                   const float* bias, int width, int n_actions, const float* units,
                   std::uint8_t* actions);
};

// The best level that this processor runs. The environment variable MATRIXWORLD_KERNELS (base,
// x86-64-v3, x86-64-v4) selects another. Throws std::invalid_argument for a name that is not one of
// these, or that this processor cannot run.
const Kernels& kernels();

}  // namespace matrixworld
