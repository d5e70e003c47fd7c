// A policy network: a genome (flat float32) read as layers. The first layer looks at binary views
// in which few cells are set, so it is a sum of weight rows; what the border adds depends only on
// the agent's place and is kept per place, made when it is first needed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "grid.hpp"
#include "kernels.hpp"
#include "observe.hpp"

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
    void sum_border();
    const float* base(int cell);
    void make_base(int number, int row, int col);
    void choose_largest(std::size_t n, std::vector<std::uint8_t>& actions) const;

    Network network_;
    Grid grid_;
    std::vector<Layer> layers_;
    std::vector<std::vector<float>> activations_;  // by layer
    std::vector<int> inputs_;

    Matrix corner_sums_;         // ((fov + 1)^2, width): summed-area table of the obstacle weights
    std::vector<int> row_case_;  // by row: which part of the border is seen
    std::vector<int> col_case_;  // by column
    int col_cases_;
    Matrix base_;                           // (row cases * col cases, width): bias + border
    std::vector<std::uint8_t> base_known_;  // by case
};

}  // namespace matrixworld
