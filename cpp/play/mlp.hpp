// A policy network: a genome (flat float32) read as layers. The first layer looks at binary views
// in which few cells are set, so it is a sum of weight rows. What the border and the obstacles add
// depends only on the agent's place: it is added up when it is first needed there, and kept.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "grid/grid.hpp"
#include "kernels/kernels.hpp"
#include "observe/observe.hpp"

namespace matrixworld {

// The genome is, layer by layer, the weights (inputs, outputs) row by row and then the biases.
// Throws std::invalid_argument for sizes below 1.
struct Network {
    Network(int fov, std::vector<int> hidden, int n_actions, Activation activation, bool sampled);

    int fov;
    std::vector<int> sizes;  // inputs, hidden layers, actions
    Activation activation;
    bool sampled;  // draw from the softmax of the outputs, or take the largest

    int n_inputs() const { return sizes.front(); }
    int n_actions() const { return sizes.back(); }
    Eigen::Index genome_size() const;
};

class Mlp {
  public:
    Mlp(const Network& network, const Grid& grid);

    // Reads a genome, which must stay where it is for as long as it is used.
    void load(const float* genome);

    // Chooses an action for each of `agents`, which are alive and of one team.
    void act(const World& world, const Occupancy& occupancy, const std::vector<int>& agents,
             const std::vector<float>& units, std::vector<std::uint8_t>& actions);

    // The outputs of the last `act`, (n agents, padded(n_actions)).
    const float* logits() const { return activations_.back().data(); }

  private:
    using Matrix = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    // Weights and bias with padded width: in the genome where that is padded already.
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
    void meet_terrain(const World& world);
    const float* obstacle_base(const World& world, int cell);
    void sum_obstacles(const World& world, int cell, float* out);
    void choose_largest(std::size_t n, std::vector<std::uint8_t>& actions) const;

    Network network_;
    Grid grid_;
    std::vector<Layer> layers_;
    std::vector<std::vector<float>> activations_;  // by layer
    std::vector<int> inputs_;
    std::vector<const float*>
        bases_;  // by agent that acts: what the sum of the first layer begins with

    Matrix corner_sums_;  // ((fov + 1)^2, width): summed-area table of the obstacle weights
    BorderCases cases_;
    Matrix border_bases_;                     // (n cases, width): bias + border
    std::vector<std::uint8_t> border_known_;  // by case

    std::shared_ptr<const Terrain> terrain_;  // of which the obstacles are kept; may be none
    Matrix obstacle_bases_;  // (n cells, width): bias + border + obstacles; of many cells, by agent
    std::vector<std::uint8_t> obstacle_known_;  // by cell
};

}  // namespace matrixworld
