// The arithmetic of the networks, compiled once for each instruction set (kernels.cpp) and chosen
// when the program runs. Every level gives the same bits: sums run in one fixed order, every
// output in its own lane, products are added by fused multiply-add, and the exponential is ours.
#pragma once

#include <cstdint>

#include "grid/positions.hpp"

namespace matrixworld {

enum class Activation : std::uint8_t { None, Relu, Tanh };

constexpr int kPad = 16;  // widths of layers in memory are multiples of this many floats

constexpr int kRowPad = 8;  // and rows of layers are added up so many at a time

inline int padded(int n) { return (n + kPad - 1) / kPad * kPad; }

struct Kernels {
    const char* level;

    // Writes the views of all agents, 0 or 1: evaders, pursuers, obstacles. What an agent sees of
    // obstacles is at obstacles[agent], fov rows of fov bytes, `stride` bytes apart.
    void (*write_byte_views)(const Positions& positions, const std::uint8_t* const* obstacles,
                             int stride, std::uint8_t* views);
    void (*write_float_views)(const Positions& positions, const std::uint8_t* const* obstacles,
                              int stride, float* views);

    // out[i, 0..width) = activation(bases[i] + the sum of the rows of `weights` for the cells that
    // other agents set in the view of agents[i]), for i < n; each cell once, in the order of the
    // numbers of the agents. Of at most kMaxPositions agents; width a multiple of kPad.
    void (*sum_seen)(const Positions& positions, const int* agents, int n,
                     const float* const* bases, const float* weights, int width,
                     Activation activation, float* out);

    // out[0, width) = activation(base + the sum of the named rows of `weights`), width a multiple
    // of kPad.
    void (*sum_rows)(const float* base, const float* weights, int stride, const int* rows, int n,
                     int width, Activation activation, float* out);

    // out[i, 0..width) = activation(bias + in[i, :] weights) for i < n; `weights` is
    // (n_in, width), `in` has `in_stride` and `out` `width` floats a row, and both have room for a
    // multiple of kRowPad rows. Of `out` the first n_out of each row are valid.
    void (*dense)(const float* in, int in_stride, int n, int n_in, const float* weights,
                  const float* bias, int width, int n_out, Activation activation, float* out);

    // Draws actions[i] from softmax(logits[i, 0..n_actions)) by inverting the distribution at
    // units[i] in [0, 1).
    void (*sample)(const float* logits, int stride, int n, int n_actions, const float* units,
                   std::uint8_t* actions);
};

// The best level that this processor runs; the environment variable MATRIXWORLD_KERNELS (base,
// x86-64-v3, x86-64-v4) asks for a lower one. Throws std::invalid_argument for any other name.
const Kernels& kernels();

}  // namespace matrixworld
