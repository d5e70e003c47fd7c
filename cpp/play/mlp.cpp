#include "play/mlp.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "grid/compiler.hpp"

namespace matrixworld {

Memory to_memory(const std::string& name) {
    if (name == "none") return Memory::None;
    if (name == "gru") return Memory::Gru;
    throw std::invalid_argument("memory: expected none or gru, got '" + name + "'");
}

Network::Network(int fov, std::vector<int> hidden, int n_actions, Activation activation,
                 bool sampled, Memory memory)
    : fov(fov), activation(activation), sampled(sampled), memory(memory) {
    require_range("fov", fov, 1, kMaxFieldOfView);
    sizes.push_back(kChannels * fov * fov);
    sizes.insert(sizes.end(), hidden.begin(), hidden.end());
    sizes.push_back(n_actions);
    for (int size : sizes) require_range("layer sizes", size, 1, kMaxLayer);
    if (memory != Memory::None && hidden.empty()) {
        throw std::invalid_argument("memory: expected a hidden layer before it, got none");
    }
}

std::vector<Network::Shape> Network::layers() const {
    std::vector<Shape> layers;
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
        layers.push_back({sizes[i], sizes[i + 1], false});
    if (memory == Memory::None) return layers;
    layers.insert(layers.begin() + 1, {2 * sizes[1], kGates * sizes[1], true});
    return layers;
}

Eigen::Index Network::genome_size() const {
    Eigen::Index size = 0;
    for (const Shape& layer : layers()) {
        size += static_cast<Eigen::Index>(layer.n_in + 1) * layer.n_out;
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
    for (const auto& [n_in, n_out, recurrent] : network.layers()) {
        Layer layer{n_in, n_out, recurrent, network.activation, {}};
        const int width = padded(layer.n_units());
        layer.weights = Rows(n_in + 1, (recurrent ? kGates : 1) * width);
        activations_.emplace_back(0, width);
        layers_.push_back(std::move(layer));
    }
    layers_.back().activation = Activation::None;
    states_ = Rows(0, padded(network.state_size()));
    const int width = layers_.front().width();
    corner_sums_ = Rows((network.fov + 1) * (network.fov + 1), width);
    border_bases_ = Rows(cases_.n_cases(), width);
    border_known_.resize(cases_.n_cases());
    obstacle_words_.resize(n_obstacle_words(network.fov));
}

void Mlp::load(const float* genome) {
    for (Layer& layer : layers_) {
        for (int row = 0; row <= layer.n_in; ++row, genome += layer.n_out) {
            if (layer.recurrent) {
                layer.load_gates(genome, layer.weights[row]);
            } else {
                std::copy_n(genome, layer.n_out, layer.weights[row]);
            }
        }
    }
    sum_border();
}

// The columns of kPad units of a gate lie beside those of its other gates (see Kernels::remember).
void Mlp::Layer::load_gates(const float* genome, float* row) const {
    for (int gate = 0; gate < kGates; ++gate, genome += n_units()) {
        for (int unit = 0; unit < n_units(); unit += kPad) {
            const int n = std::min(kPad, n_units() - unit);
            std::copy_n(genome + unit, n, row + unit * kGates + gate * kPad);
        }
    }
}

// Fills the summed-area table: corner_sums(r, c) is the sum of the obstacle weights of the window's
// cells above row r and left of column c. The sum over any rectangle is then a sum of four corners.
void Mlp::sum_border() {
    const int fov = network_.fov;
    const int first = kObstacles * fov * fov;
    const auto corner = [&](int r, int c) { return corner_sums_.array(r * (fov + 1) + c); };
    for (int r = 0; r < fov; ++r) {
        for (int c = 0; c < fov; ++c) {
            corner(r + 1, c + 1) = layers_.front().weights.array(first + r * fov + c) +
                                   corner(r, c + 1) + (corner(r + 1, c) - corner(r, c));
        }
    }
    // The bases of the last genome hold no longer.
    std::fill(border_known_.begin(), border_known_.end(), 0);
    for (Kept& kept : kept_) std::fill(kept.known.begin(), kept.known.end(), 0);
}

// Bias + obstacle weights of all cells of the window that lie outside the grid.
const float* Mlp::border_base(int row, int col) {
    const int number = cases_.number(row, col);
    if (!border_known_[number]) {
        make_border_base(number, row, col);
        border_known_[number] = 1;
    }
    return border_bases_[number];
}

void Mlp::make_border_base(int number, int row, int col) {
    const int fov = network_.fov;
    const int reach = fov / 2;
    const int top = std::max(0, reach - row);
    const int left = std::max(0, reach - col);
    const int bottom = std::min(fov, reach + grid_.rows() - row);
    const int right = std::min(fov, reach + grid_.cols() - col);
    const auto corner = [&](int r, int c) { return corner_sums_.array(r * (fov + 1) + c); };
    Layer& first = layers_.front();
    // All cells of the window, minus the rectangle inside the grid.
    border_bases_.array(number) = first.weights.array(first.n_in) +
                                  (corner(fov, fov) - (corner(bottom, right) - corner(top, right) -
                                                       corner(bottom, left) + corner(top, left)));
}

// Bias + border + obstacles for an agent on this cell: kept, or computed into `room`.
const float* Mlp::obstacle_base(const World& world, Kept* kept, int row, int col, float* room) {
    const int cell = grid_.cell(row, col);
    if (kept && kept->known[cell]) {
        // The tables of all worlds leave the inner caches, and the row is read only later.
        const float* known = kept->bases[cell];
        for (int i = 0; i < layers_.front().width(); i += kPad) prefetch(known + i);
        return known;
    }
    float* const base = kept ? kept->bases[cell] : room;
    sum_obstacles(world, row, col, base);
    if (kept) kept->known[cell] = 1;
    return base;
}

// The kept bases of a world that plays in this slot, or null where they take too much memory. Worlds
// with one terrain share the first slot.
Mlp::Kept* Mlp::find_kept(const World& world, std::size_t slot) {
    if (!world.has_own_terrain()) slot = 0;
    const int width = layers_.front().width();
    if (static_cast<Eigen::Index>(slot + 1) * grid_.n_cells() * width > kMostKept) return nullptr;
    while (kept_.size() <= slot) kept_.push_back({nullptr, Rows(0, width), {}});
    Kept& kept = kept_[slot];
    if (world.shared_terrain() != kept.terrain) {
        kept.terrain = world.shared_terrain();
        kept.known.assign(static_cast<std::size_t>(grid_.n_cells()), 0);
        kept.bases.resize(grid_.n_cells());
    }
    return &kept;
}

void Mlp::sum_obstacles(const World& world, int row, int col, float* out) {
    const Rows& weights = layers_.front().weights;
    const int first = kObstacles * network_.fov * network_.fov;
    pack_obstacles(world, row, col, obstacle_words_.data());
    kernels().sum_bits(border_base(row, col), weights[first], obstacle_words_.data(),
                       static_cast<int>(obstacle_words_.size()), weights.width(), out);
}

// The kernels compute whole blocks of rows; what they write after row n is not read.
void Mlp::make_room(std::size_t n) {
    const auto rows = static_cast<Eigen::Index>((n + kPad - 1) / kPad * kPad);
    for (Rows& activations : activations_) activations.grow(rows);
    states_.grow(rows);
}

void Mlp::act(const World& world, const Occupancy& occupancy, const std::vector<int>& agents,
              const std::vector<float>& units, std::vector<std::uint8_t>& actions) {
    make_room(agents.size());
    const int n = static_cast<int>(agents.size());
    if (world.config().n_agents() <= kMaxPositions) {
        const Positions positions = occupancy.position_table().positions();
        first_layer(world, positions, agents.data(), n, 0, activations_.front()[0]);
    } else {
        sum_listed(world, occupancy, agents);
    }
    for (int i = 0; i < n && network_.memory != Memory::None; ++i) {
        world.memories().recall(agents[i], world.steps(), network_.state_size(), states_[i]);
    }
    for (std::size_t i = 1; i < layers_.size(); ++i) pass(i, agents.size());
    actions.resize(agents.size());
    kernels().choose(logits(), layers_.back().width(), n, network_.n_actions(),
                     network_.sampled ? units.data() : nullptr, actions.data());
}

void Mlp::look(const World& world, const Crowd& crowd, int first, int last, Eigen::Index row,
               std::size_t slot) {
    static const std::array<int, kMaxPositions> places = [] {
        std::array<int, kMaxPositions> all{};
        std::iota(all.begin(), all.end(), 0);
        return all;
    }();
    first_layer(world, crowd.positions(), places.data() + first, last - first, slot,
                activations_.front()[row]);
}

void Mlp::choose(std::size_t n, const float* units, std::uint8_t* actions) {
    const std::size_t last = layers_.size() - 1;
    for (std::size_t i = 1; i < last; ++i) pass(i, n);
    const Layer& layer = layers_[last];
    const Rows& in = layers_[last - 1].recurrent ? states_ : activations_[last - 1];
    kernels().finish(in[0], in.width(), static_cast<int>(n), layer.n_in, layer.weights[0],
                     layer.bias(), layer.width(), layer.n_out, network_.sampled ? units : nullptr,
                     actions);
}

void Mlp::pass(std::size_t i, std::size_t n) {
    const Layer& layer = layers_[i];
    if (layer.recurrent) return remember(layer, n);
    const Rows& in = layers_[i - 1].recurrent ? states_ : activations_[i - 1];
    kernels().dense(in[0], in.width(), static_cast<int>(n), layer.n_in, layer.weights[0],
                    layer.bias(), layer.width(), layer.n_out, layer.activation, activations_[i][0]);
}

// The recurrent layer, the one after the first. Its outputs are what the agents remember next.
void Mlp::remember(const Layer& layer, std::size_t n) {
    const Rows& in = activations_[0];
    kernels().remember(in[0], in.width(), states_[0], static_cast<int>(n), layer.n_units(),
                       layer.weights[0], layer.bias(), activations_[1][0]);
    std::swap(states_, activations_[1]);
}

// Adds the agents in view to the bases. With few agents in the world a kernel compares all their
// positions in vector registers.
void Mlp::first_layer(const World& world, const Positions& positions, const int* agents, int n,
                      std::size_t slot, float* out) {
    const Layer& first = layers_.front();
    find_bases(world, positions, agents, n, slot, out);
    kernels().sum_seen(positions, agents, n, bases_.data(), first.weights[0], first.width(),
                       first.activation, out);
}

// The same with many agents: only the cells of each view are visited.
void Mlp::sum_listed(const World& world, const Occupancy& occupancy,
                     const std::vector<int>& agents) {
    const Layer& first = layers_.front();
    float* out = activations_.front()[0];
    find_bases(world, occupancy.position_table().positions(), agents.data(),
               static_cast<int>(agents.size()), 0, out);
    for (std::size_t i = 0; i < agents.size(); ++i, out += first.width()) {
        const int n = list_agents(world, occupancy, agents[i], inputs_.data());
        kernels().sum_rows(bases_[i], first.weights[0], first.width(), inputs_.data(), n,
                           first.width(), first.activation, out);
    }
}

// Bases that are not kept are computed into the rows of `out`.
void Mlp::find_bases(const World& world, const Positions& positions, const int* agents, int n,
                     std::size_t slot, float* out) {
    bases_.resize(static_cast<std::size_t>(n));
    const bool obstacles = world.terrain().has_obstacles;
    Kept* const kept = obstacles ? find_kept(world, slot) : nullptr;
    for (int i = 0; i < n; ++i) {
        const int row = positions.rows[agents[i]];
        const int col = positions.cols[agents[i]];
        float* const room = out + static_cast<std::ptrdiff_t>(i) * layers_.front().width();
        bases_[i] = obstacles ? obstacle_base(world, kept, row, col, room) : border_base(row, col);
    }
}

}  // namespace matrixworld
