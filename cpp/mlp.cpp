#include "mlp.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace matrixworld {

Network::Network(int fov, std::vector<int> hidden, int n_actions, Activation activation,
                 bool sampled)
    : fov(fov), activation(activation), sampled(sampled) {
    sizes.push_back(kChannels * fov * fov);
    sizes.insert(sizes.end(), hidden.begin(), hidden.end());
    sizes.push_back(n_actions);
    for (int size : sizes) {
        if (size < 1) {
            throw std::invalid_argument("layer sizes: expected at least 1, got " +
                                        std::to_string(size));
        }
    }
}

Eigen::Index Network::genome_size() const {
    Eigen::Index size = 0;
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i) {
        size += static_cast<Eigen::Index>(sizes[i] + 1) * sizes[i + 1];
    }
    return size;
}

namespace {

// For each place along a side of the grid, a number that is the same for all places from which the
// same part of the border is seen.
std::vector<int> border_cases(int side, int fov) {
    const int cases = std::min(side, fov);
    const int middle = std::min(fov / 2, cases - 1);
    std::vector<int> numbers(side);
    for (int place = 0; place < side; ++place) {
        numbers[place] = std::min(place, std::max(middle, place - (side - cases)));
    }
    return numbers;
}

}  // namespace

Mlp::Mlp(const Network& network, const Grid& grid)
    : network_(network),
      grid_(grid),
      inputs_(network.n_inputs()),
      row_case_(border_cases(grid.rows(), network.fov)),
      col_case_(border_cases(grid.cols(), network.fov)),
      col_cases_(col_case_.back() + 1) {
    for (std::size_t i = 0; i + 1 < network.sizes.size(); ++i) {
        Layer layer;
        layer.n_in = network.sizes[i];
        layer.n_out = network.sizes[i + 1];
        layer.width = padded(layer.n_out);
        const bool last = i + 2 == network.sizes.size();
        layer.activation = last ? Activation::None : network.activation;
        if (layer.width != layer.n_out) {
            layer.padded_weights = Matrix::Zero(layer.n_in, layer.width);
            layer.padded_bias = Matrix::Zero(1, layer.width);
        }
        layers_.push_back(std::move(layer));
    }
    activations_.resize(layers_.size());
    corner_sums_ = Matrix::Zero((network.fov + 1) * (network.fov + 1), layers_[0].width);
    const int n_cases = (row_case_.back() + 1) * col_cases_;
    base_ = Matrix::Zero(n_cases, layers_[0].width);
    base_known_.resize(n_cases);
}

void Mlp::load(const float* genome) {
    for (Layer& layer : layers_) {
        read(layer, genome);
        genome += static_cast<Eigen::Index>(layer.n_in + 1) * layer.n_out;
    }
    sum_border();
}

void Mlp::read(Layer& layer, const float* genome) {
    const float* bias = genome + static_cast<Eigen::Index>(layer.n_in) * layer.n_out;
    if (layer.width == layer.n_out) {
        layer.weights = genome;
        layer.bias = bias;
        return;
    }
    layer.padded_weights.leftCols(layer.n_out) =
        Eigen::Map<const Matrix>(genome, layer.n_in, layer.n_out);
    layer.padded_bias.leftCols(layer.n_out) = Eigen::Map<const Matrix>(bias, 1, layer.n_out);
    layer.weights = layer.padded_weights.data();
    layer.bias = layer.padded_bias.data();
}

// corner_sums(r, c) = the sum of the obstacle weights of the window's cells above r and left of c.
void Mlp::sum_border() {
    const int fov = network_.fov;
    const Layer& first = layers_.front();
    const Eigen::Map<const Matrix> obstacles(
        first.weights + static_cast<Eigen::Index>(kObstacles * fov * fov) * first.width, fov * fov,
        first.width);
    const auto corner = [&](int r, int c) { return corner_sums_.row(r * (fov + 1) + c); };
    for (int r = 0; r < fov; ++r) {
        for (int c = 0; c < fov; ++c) {
            corner(r + 1, c + 1) =
                obstacles.row(r * fov + c) + corner(r, c + 1) + (corner(r + 1, c) - corner(r, c));
        }
    }
    std::fill(base_known_.begin(), base_known_.end(), 0);
}

// Bias plus the weights of all cells of the window that lie outside the grid.
const float* Mlp::base(int cell) {
    const int row = grid_.row(cell);
    const int col = grid_.col(cell);
    const int number = row_case_[row] * col_cases_ + col_case_[col];
    if (!base_known_[number]) {
        make_base(number, row, col);
        base_known_[number] = 1;
    }
    return &base_(number, 0);
}

void Mlp::make_base(int number, int row, int col) {
    const int fov = network_.fov;
    const int reach = fov / 2;
    const int top = std::max(0, reach - row);
    const int left = std::max(0, reach - col);
    const int bottom = std::min(fov, reach + grid_.rows() - row);
    const int right = std::min(fov, reach + grid_.cols() - col);
    const auto corner = [&](int r, int c) { return corner_sums_.row(r * (fov + 1) + c); };
    const Eigen::Map<const Matrix> bias(layers_.front().bias, 1, layers_.front().width);
    base_.row(number) =
        bias.row(0) + (corner(fov, fov) - (corner(bottom, right) - corner(top, right) -
                                           corner(bottom, left) + corner(top, left)));
}

void Mlp::act(const World& world, const Occupancy& occupancy, const std::vector<int>& agents,
              const std::vector<float>& units, std::vector<std::uint8_t>& actions) {
    const Kernels& kernel = kernels();
    const int n = static_cast<int>(agents.size());
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const std::size_t room = agents.size() * static_cast<std::size_t>(layers_[i].width);
        if (activations_[i].size() < room) activations_[i].resize(room);
    }
    const Layer& first = layers_.front();
    for (int i = 0; i < n; ++i) {
        const int n_set = list_view(world, occupancy, agents[i], inputs_.data());
        kernel.sum_rows(base(world.cell(agents[i])), first.weights, first.width, inputs_.data(),
                        n_set, first.width, first.activation,
                        activations_[0].data() + static_cast<std::size_t>(i) * first.width);
    }
    for (std::size_t i = 1; i < layers_.size(); ++i) {
        const Layer& layer = layers_[i];
        kernel.dense(activations_[i - 1].data(), layers_[i - 1].width, n, layer.n_in, layer.weights,
                     layer.bias, layer.width, layer.n_out, layer.activation,
                     activations_[i].data());
    }
    actions.resize(agents.size());
    if (network_.sampled) {
        kernel.sample(logits(), layers_.back().width, n, network_.n_actions(), units.data(),
                      actions.data());
    } else {
        choose_largest(agents.size(), actions);
    }
}

// The first of the largest outputs.
void Mlp::choose_largest(std::size_t n, std::vector<std::uint8_t>& actions) const {
    for (std::size_t i = 0; i < n; ++i) {
        const float* row = logits() + i * static_cast<std::size_t>(layers_.back().width);
        const float* largest = std::max_element(row, row + network_.n_actions());
        actions[i] = static_cast<std::uint8_t>(largest - row);
    }
}

}  // namespace matrixworld
