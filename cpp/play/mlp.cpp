#include "play/mlp.hpp"

#include <algorithm>

namespace matrixworld {

Network::Network(int fov, std::vector<int> hidden, int n_actions, Activation activation,
                 bool sampled)
    : fov(fov), activation(activation), sampled(sampled) {
    require_range("fov", fov, 1, kMaxFieldOfView);
    sizes.push_back(kChannels * fov * fov);
    sizes.insert(sizes.end(), hidden.begin(), hidden.end());
    sizes.push_back(n_actions);
    for (int size : sizes) require_range("layer sizes", size, 1, kMaxLayer);
}

Eigen::Index Network::genome_size() const {
    Eigen::Index size = 0;
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i) {
        size += static_cast<Eigen::Index>(sizes[i] + 1) * sizes[i + 1];
    }
    return size;
}

namespace {

// Obstacle bases are kept up to this many floats (16 MiB a thread and network). On larger grids they
// are computed anew for each agent and step.
constexpr Eigen::Index kMostKept = Eigen::Index{1} << 22;

}  // namespace

Mlp::Mlp(const Network& network, const Grid& grid)
    : network_(network), grid_(grid), inputs_(network.n_inputs()), cases_(grid, network.fov) {
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
    border_bases_ = Matrix::Zero(cases_.n_cases(), layers_[0].width);
    border_known_.resize(cases_.n_cases());
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

// Fills the summed-area table: corner_sums(r, c) is the sum of the obstacle weights of the window's
// cells above row r and left of column c. The sum over any rectangle is then a sum of four corners.
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
    // The bases of the last genome hold no longer.
    std::fill(border_known_.begin(), border_known_.end(), 0);
    std::fill(obstacle_known_.begin(), obstacle_known_.end(), 0);
}

// Bias + obstacle weights of all cells of the window that lie outside the grid.
const float* Mlp::border_base(int row, int col) {
    const int number = cases_.number(row, col);
    if (!border_known_[number]) {
        make_border_base(number, row, col);
        border_known_[number] = 1;
    }
    return &border_bases_(number, 0);
}

void Mlp::make_border_base(int number, int row, int col) {
    const int fov = network_.fov;
    const int reach = fov / 2;
    const int top = std::max(0, reach - row);
    const int left = std::max(0, reach - col);
    const int bottom = std::min(fov, reach + grid_.rows() - row);
    const int right = std::min(fov, reach + grid_.cols() - col);
    const auto corner = [&](int r, int c) { return corner_sums_.row(r * (fov + 1) + c); };
    const Eigen::Map<const Matrix> bias(layers_.front().bias, 1, layers_.front().width);
    // All cells of the window, minus the rectangle inside the grid.
    border_bases_.row(number) =
        bias.row(0) + (corner(fov, fov) - (corner(bottom, right) - corner(top, right) -
                                           corner(bottom, left) + corner(top, left)));
}

// Forgets the obstacle bases if the world has another terrain than at the last call.
void Mlp::use_terrain(const World& world) {
    if (world.shared_terrain() == terrain_) return;
    terrain_ = world.shared_terrain();
    obstacle_known_.assign(static_cast<std::size_t>(grid_.n_cells()), 0);
    obstacle_bases_.resize(grid_.n_cells(), layers_.front().width);
}

const float* Mlp::obstacle_base(const World& world, int cell) {
    float* const base = &obstacle_bases_(cell, 0);
    if (!obstacle_known_[cell]) {
        sum_obstacles(world, cell, base);
        obstacle_known_[cell] = 1;
    }
    return base;
}

void Mlp::sum_obstacles(const World& world, int cell, float* out) {
    const Layer& first = layers_.front();
    const int n = list_obstacles(world, cell, inputs_.data());
    kernels().sum_rows(border_base(grid_.row(cell), grid_.col(cell)), first.weights, first.width,
                       inputs_.data(), n, first.width, Activation::None, out);
}

void Mlp::act(const World& world, const Occupancy& occupancy, const std::vector<int>& agents,
              const std::vector<float>& units, std::vector<std::uint8_t>& actions) {
    const Kernels& kernel = kernels();
    const int n = static_cast<int>(agents.size());
    // The kernels compute whole blocks of kRowPad rows; what they write after row n is not read.
    const std::size_t rows = (agents.size() + kRowPad - 1) / kRowPad * kRowPad;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const std::size_t room = rows * static_cast<std::size_t>(layers_[i].width);
        if (activations_[i].size() < room) activations_[i].resize(room);
    }
    first_layer(world, occupancy, agents);
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

void Mlp::first_layer(const World& world, const Occupancy& occupancy,
                      const std::vector<int>& agents) {
    bases_.resize(agents.size());
    const PositionTable& positions = occupancy.position_table();
    const Eigen::Index width = layers_.front().width;
    const bool obstacles = world.terrain().has_obstacles;
    const bool kept = grid_.n_cells() * width <= kMostKept;
    if (obstacles && kept) use_terrain(world);
    if (obstacles && !kept) obstacle_bases_.resize(static_cast<Eigen::Index>(agents.size()), width);
    for (std::size_t i = 0; i < agents.size(); ++i) {
        const int cell = world.cell(agents[i]);
        if (!obstacles) {
            bases_[i] = border_base(positions.row(agents[i]), positions.col(agents[i]));
        } else if (kept) {
            bases_[i] = obstacle_base(world, cell);
        } else {
            float* const base = &obstacle_bases_(static_cast<Eigen::Index>(i), 0);
            sum_obstacles(world, cell, base);
            bases_[i] = base;
        }
    }
    sum_seen(world, occupancy, agents);
}

// Adds the agents in view to the bases. With few agents in the world a kernel compares all their
// positions in vector registers; with many, only the cells of each view are visited.
void Mlp::sum_seen(const World& world, const Occupancy& occupancy, const std::vector<int>& agents) {
    const Layer& first = layers_.front();
    float* out = activations_.front().data();
    if (world.config().n_agents() <= kMaxPositions) {
        kernels().sum_seen(occupancy.position_table().positions(), agents.data(),
                           static_cast<int>(agents.size()), bases_.data(), first.weights,
                           first.width, first.activation, out);
        return;
    }
    for (std::size_t i = 0; i < agents.size(); ++i, out += first.width) {
        const int n = list_agents(world, occupancy, agents[i], inputs_.data());
        kernels().sum_rows(bases_[i], first.weights, first.width, inputs_.data(), n, first.width,
                           first.activation, out);
    }
}

// Takes the action with the largest output; the first of them if several are equal.
void Mlp::choose_largest(std::size_t n, std::vector<std::uint8_t>& actions) const {
    for (std::size_t i = 0; i < n; ++i) {
        const float* row = logits() + i * static_cast<std::size_t>(layers_.back().width);
        const float* largest = std::max_element(row, row + network_.n_actions());
        actions[i] = static_cast<std::uint8_t>(largest - row);
    }
}

}  // namespace matrixworld
