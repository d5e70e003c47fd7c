// A policy network (multilayer perceptron, with or without memory): a genome, flat float32, read as
// layers.
//
// The first layer reads binary views in which few cells are set, so its output is a sum of few weight
// rows: bias + border + obstacles + agents in view. The first three depend only on the agent's cell.
// Their sum (a "base") is computed when an agent first stands there, and kept for later steps.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "grid/grid.hpp"
#include "kernels/kernels.hpp"
#include "observe/crowd.hpp"
#include "observe/observe.hpp"

namespace matrixworld {

// "none" or "gru". Throws std::invalid_argument for other names.
Memory to_memory(const std::string& name);

constexpr int kMaxLayer = 1 << 20;  // units; the largest layer, so that sizes fit their types

// The genome is, layer by layer, the weights (inputs, outputs) row by row and then the biases. With
// memory, a recurrent layer of as many units follows the first hidden layer. Its inputs are those and
// what each unit remembers; its outputs are the gates one after the other, with a column for each unit.
// Throws std::invalid_argument for sizes below 1 and above kMaxLayer, for a field of view that no
// world has, and for memory without hidden layers.
struct Network {
    Network(int fov, std::vector<int> hidden, int n_actions, Activation activation, bool sampled,
            Memory memory = Memory::None);

    int fov;
    std::vector<int> sizes;  // inputs, hidden layers, actions
    Activation activation;
    bool sampled;  // draw the action from the softmax of the outputs, or take the largest output
    Memory memory;

    int n_inputs() const { return sizes.front(); }
    int n_actions() const { return sizes.back(); }
    Eigen::Index genome_size() const;
    // How many numbers an agent remembers.
    int state_size() const { return memory == Memory::None ? 0 : sizes[1]; }

    struct Shape {
        int n_in;
        int n_out;
        bool recurrent;
    };
    std::vector<Shape> layers() const;
};

// Rows of `width` floats, a multiple of kPad, each of which begins at a multiple of the widest vector:
// so no vector that is read lies in two lines of the cache.
class Rows {
  public:
    using Matrix = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    Rows() = default;
    Rows(Eigen::Index n, int width) : width_(width) { resize(n); }

    void resize(Eigen::Index n) { vectors_.resize(static_cast<std::size_t>(n * width_ / kPad)); }
    void grow(Eigen::Index n) {
        if (static_cast<std::size_t>(n * width_ / kPad) > vectors_.size()) resize(n);
    }
    int width() const { return width_; }
    float* operator[](Eigen::Index row) { return data() + row * width_; }
    const float* operator[](Eigen::Index row) const { return data() + row * width_; }
    // The row as an array, for arithmetic.
    Eigen::Map<Matrix> array(Eigen::Index row) { return {(*this)[row], 1, width_}; }

  private:
    struct alignas(kPad * sizeof(float)) Vector {
        float numbers[kPad] = {};
    };

    float* data() { return reinterpret_cast<float*>(vectors_.data()); }
    const float* data() const { return reinterpret_cast<const float*>(vectors_.data()); }

    int width_ = 0;
    std::vector<Vector> vectors_;
};

class Mlp {
  public:
    Mlp(const Network& network, const Grid& grid);

    // Reads a genome, which must stay in memory as long as it is used.
    void load(const float* genome);

    // Chooses an action for each of `agents`, which are alive and belong to one team. units[i], in
    // [0, 1), decides for agents[i] where actions are sampled. What the agents remember is read from
    // the world; what they remember next is in the first rows of `states`.
    void act(const World& world, const Occupancy& occupancy, const std::vector<int>& agents,
             const std::vector<float>& units, std::vector<std::uint8_t>& actions);

    const Network& network() const { return network_; }

    // The outputs of the last `act`, (n agents, padded(n_actions)).
    const float* logits() const { return activations_.back()[0]; }

    // The same for agents of several worlds at once. `look` reads the views of the agents [first,
    // last) of a crowd, from row `row` on; `slot` tells apart the worlds that
    // play at the same time. Then `choose` chooses the actions of the first n rows.
    // With memory, `choose` replaces what the agents of the rows remember, `states`, (n rows,
    // state_size), by what they remember next.
    // Preconditions: `make_room` for so many rows; room for a multiple of kPad units and actions.
    Rows& states() { return states_; }
    void make_room(std::size_t n);
    void look(const World& world, const Crowd& crowd, int first, int last, Eigen::Index row,
              std::size_t slot);
    void choose(std::size_t n, const float* units, std::uint8_t* actions);

  private:
    struct Layer {
        int n_in = 0;
        int n_out = 0;
        bool recurrent = false;
        Activation activation = Activation::None;
        Rows weights;  // (n_in, n_out), padded, and then the bias

        int n_units() const { return recurrent ? n_out / kGates : n_out; }
        void load_gates(const float* genome, float* row) const;

        int width() const { return weights.width(); }
        const float* bias() const { return weights[n_in]; }
    };

    // Sums that are kept for the obstacles of one world, or of all worlds with the same terrain.
    struct Kept {
        std::shared_ptr<const Terrain> terrain;  // may be null
        Rows bases;                              // (n cells, width): bias + border + obstacles
        std::vector<std::uint8_t> known;         // by cell
    };

    void pass(std::size_t layer, std::size_t n);
    void remember(const Layer& layer, std::size_t n);
    void first_layer(const World& world, const Positions& positions, const int* agents, int n,
                     std::size_t slot, float* out);
    void find_bases(const World& world, const Positions& positions, const int* agents, int n,
                    std::size_t slot, float* out);
    void sum_listed(const World& world, const Occupancy& occupancy, const std::vector<int>& agents);

    void sum_border();
    const float* border_base(int row, int col);
    void make_border_base(int number, int row, int col);
    const float* obstacle_base(const World& world, Kept* kept, int row, int col, float* room);
    Kept* find_kept(const World& world, std::size_t slot);
    void sum_obstacles(const World& world, int row, int col, float* out);

    Network network_;
    Grid grid_;
    std::vector<Layer> layers_;
    std::vector<Rows> activations_;    // by layer
    Rows states_;                      // by row: what the agent remembers
    std::vector<int> inputs_;          // indices of the inputs that are 1
    std::vector<const float*> bases_;  // by agent that acts

    Rows corner_sums_;   // ((fov + 1)^2, width): summed-area table of the obstacle weights
    BorderCases cases_;  // cells with the same border in view are one case
    Rows border_bases_;  // (n cases, width): bias + border
    std::vector<std::uint8_t> border_known_;  // by case

    std::vector<Kept> kept_;                     // by slot
    std::vector<std::uint64_t> obstacle_words_;  // obstacles in one view
};

}  // namespace matrixworld
