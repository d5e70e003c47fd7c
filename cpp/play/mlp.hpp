// A policy network (multilayer perceptron): a genome, flat float32, read as layers.
//
// The first layer reads binary views in which few cells are set, so its output is a sum of few weight
// rows: bias + border + obstacles + agents in view. The first three depend only on the agent's cell.
// Their sum (a "base") is computed when an agent first stands there, and kept for later steps.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "grid/grid.hpp"
#include "kernels/kernels.hpp"
#include "observe/observe.hpp"

namespace matrixworld {

constexpr int kMaxLayer = 1 << 20;  // units; the largest layer, so that sizes fit their types

// The genome is, layer by layer, the weights (inputs, outputs) row by row and then the biases.
// Throws std::invalid_argument for sizes below 1 and above kMaxLayer, and for a field of view that
// no world has.
struct Network {
    Network(int fov, std::vector<int> hidden, int n_actions, Activation activation, bool sampled);

    int fov;
    std::vector<int> sizes;  // inputs, hidden layers, actions
    Activation activation;
    bool sampled;  // draw the action from the softmax of the outputs, or take the largest output

    int n_inputs() const { return sizes.front(); }
    int n_actions() const { return sizes.back(); }
    Eigen::Index genome_size() const;
};

class Mlp {
  public:
    Mlp(const Network& network, const Grid& grid);

    // Reads a genome, which must stay in memory as long as it is used.
    void load(const float* genome);

    // Chooses an action for each of `agents`, which are alive and belong to one team. units[i], in
    // [0, 1), decides for agents[i] where actions are sampled.
    void act(const World& world, const Occupancy& occupancy, const std::vector<int>& agents,
             const std::vector<float>& units, std::vector<std::uint8_t>& actions);

    // The outputs of the last `act`, (n agents, padded(n_actions)).
    const float* logits() const { return activations_.back().data(); }

  private:
    using Matrix = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    // Weights and bias, each row padded to whole vector registers. Where the layer's width needs no
    // padding they are read in the genome itself, else from a padded copy.
    struct Layer {
        int n_in = 0;
        int n_out = 0;
        int width = 0;
        Activation activation = Activation::None;
        const float* weights = nullptr;
        const float* bias = nullptr;
        Matrix padded_weights;
        Matrix padded_bias;
    };

    void read(Layer& layer, const float* genome);
    void first_layer(const World& world, const Occupancy& occupancy,
                     const std::vector<int>& agents);
    void sum_seen(const World& world, const Occupancy& occupancy, const std::vector<int>& agents);

    void sum_border();
    const float* border_base(int row, int col);
    void make_border_base(int number, int row, int col);
    void use_terrain(const World& world);
    const float* obstacle_base(const World& world, int cell);
    void sum_obstacles(const World& world, int cell, float* out);
    void choose_largest(std::size_t n, std::vector<std::uint8_t>& actions) const;

    Network network_;
    Grid grid_;
    std::vector<Layer> layers_;
    std::vector<std::vector<float>> activations_;  // by layer
    std::vector<int> inputs_;                      // indices of the inputs that are 1
    std::vector<const float*> bases_;              // by agent that acts

    Matrix corner_sums_;   // ((fov + 1)^2, width): summed-area table of the obstacle weights
    BorderCases cases_;    // cells with the same border in view are one case
    Matrix border_bases_;  // (n cases, width): bias + border
    std::vector<std::uint8_t> border_known_;  // by case

    std::shared_ptr<const Terrain> terrain_;  // for which obstacle_bases_ hold; may be null
    // (n cells, width): bias + border + obstacles. On large grids (n agents, width), not kept.
    Matrix obstacle_bases_;
    std::vector<std::uint8_t> obstacle_known_;  // by cell
};

}  // namespace matrixworld
