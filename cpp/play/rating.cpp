#include "play/rating.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "kernels/kernels.hpp"
#include "play/program.hpp"

namespace matrixworld {

MoveMask to_mask(const std::string& name) {
    if (name == "none") return MoveMask::None;
    if (name == "obstacles") return MoveMask::Obstacles;
    if (name == "right-of-way") return MoveMask::RightOfWay;
    throw std::invalid_argument("mask: expected none, obstacles or right-of-way, got '" + name +
                                "'");
}

// ---- The shape ----------------------------------------------------------------------------------

void RatingShape::validate() const {
    require_range("fov", fov, 1, kMaxFieldOfView);
    if (inputs.empty()) throw std::invalid_argument("inputs: expected at least one, got none");
    for (const int input : inputs) require_range("inputs", input, 0, kInputs - 1);
    for (const int size : hidden) require_range("hidden", size, 1, kMaxLayer);
    require_range("length", length, 0, kMaxLayer);
}

Eigen::Index RatingShape::genome_size() const {
    if (length > 0) return Eigen::Index{2} * length;
    Eigen::Index size = 0;
    auto n_in = static_cast<Eigen::Index>(inputs.size());
    for (const int n_out : hidden) {
        size += (n_in + 1) * n_out;
        n_in = n_out;
    }
    return size + n_in;
}

void RatingShape::check_fits(const std::string& name, const Config& config) const {
    if (fov != config.fov || n_actions != config.n_actions()) {
        throw std::invalid_argument(
            name + ": expected a policy for fov " + std::to_string(config.fov) + " and " +
            std::to_string(config.n_actions()) + " actions, got fov " + std::to_string(fov) +
            " and " + std::to_string(n_actions) + " actions");
    }
    const int least = mask == MoveMask::None        ? 1
                      : mask == MoveMask::Obstacles ? 3
                                                    : RightOfWay::kLeastFov;
    if (fov >= least) return;
    throw std::invalid_argument(name + ": expected a fov of at least " + std::to_string(least) +
                                " for the mask, got " + std::to_string(fov));
}

void RatingShape::check_genomes(const float* genomes, std::size_t n) const {
    if (length == 0) return;  // any numbers are weights
    const auto rater = make_rater(*this);
    for (std::size_t i = 0; i < n; ++i) {
        try {
            rater->load(genomes + static_cast<Eigen::Index>(i) * genome_size());
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("genomes, genome " + std::to_string(i) + ", " +
                                        error.what());
        }
    }
}

// ---- A network ----------------------------------------------------------------------------------

namespace {

// The genome is, for each hidden layer, the weights (inputs, units) row by row and then the biases;
// then one weight for each input of the last sum. A bias of that sum would change no choice.
class RatingNetwork : public MoveRater {
  public:
    explicit RatingNetwork(const RatingShape& shape) : shape_(shape) {
        std::size_t widest = 1;
        for (const int size : shape.hidden) {
            widest = std::max(widest, static_cast<std::size_t>(size));
        }
        for (auto& layer : units_) layer.resize(widest * kRatedAtOnce);
        all_.resize(widest);
        std::iota(all_.begin(), all_.end(), 0);
    }

    void load(const float* genome) override {
        const int width = shape_.hidden.empty() ? 1 : shape_.hidden.front();
        reads_ = 0;
        used_.clear();
        weights_.clear();
        const int n_in = static_cast<int>(shape_.inputs.size());
        for (int i = 0; i < n_in; ++i) {
            const float* const row = genome + static_cast<std::ptrdiff_t>(i) * width;
            if (std::all_of(row, row + width, [](float weight) { return weight == 0; })) continue;
            reads_ |= 1u << shape_.inputs[i];
            used_.push_back(shape_.inputs[i]);
            weights_.insert(weights_.end(), row, row + width);
        }
        const float* const rest = genome + static_cast<std::ptrdiff_t>(n_in) * width;
        weights_.insert(weights_.end(), rest, genome + shape_.genome_size());
    }

    void rate(const MoveRows* rows, int n, MoveRatings* ratings) override {
        constexpr float kLowest = std::numeric_limits<float>::lowest();
        MoveLayer layer{};
        layer.n_moves = shape_.n_actions;
        layer.n_agents = n;
        layer.in = rows->of[0];
        layer.in_stride = sizeof(MoveRows) / sizeof(float);
        layer.rows = used_.data();
        layer.n_in = static_cast<int>(used_.size());
        layer.weights = weights_.data();
        for (std::size_t i = 0; i < shape_.hidden.size(); ++i) {
            layer.n_units = shape_.hidden[i];
            layer.biases = layer.weights + static_cast<std::ptrdiff_t>(layer.n_in) * layer.n_units;
            layer.out = units_[i % 2].data()->of;
            layer.out_stride = static_cast<std::ptrdiff_t>(all_.size()) * kMoveLanes;
            kernels().rate_moves(layer);
            layer.in = layer.out;
            layer.in_stride = layer.out_stride;
            layer.rows = all_.data();
            layer.n_in = layer.n_units;
            layer.weights = layer.biases + layer.n_units;
        }
        layer.n_units = 1;
        layer.biases = nullptr;
        layer.least = kLowest;
        layer.out = ratings->of;
        layer.out_stride = kMoveLanes;
        kernels().rate_moves(layer);
    }

    std::uint32_t reads() const override { return reads_; }

  private:
    RatingShape shape_;
    std::uint32_t reads_ = 0;
    std::vector<int> used_;              // inputs with a weight that is not 0
    std::vector<float> weights_;         // of these inputs, and all others
    std::vector<int> all_;               // 0, 1, ...: the units of a hidden layer
    std::vector<MoveRatings> units_[2];  // of layers in turn, by agent and unit
};

}  // namespace

std::unique_ptr<MoveRater> make_rater(const RatingShape& shape) {
    if (shape.length > 0) return std::make_unique<Program>(shape);
    return std::make_unique<RatingNetwork>(shape);
}

// ---- The choice ---------------------------------------------------------------------------------

RatingPolicy::RatingPolicy(const RatingShape& shape, const Config& config)
    : inputs_(config), mask_(shape.mask), n_moves_(config.n_actions()), rater_(make_rater(shape)) {}

void RatingPolicy::load(const float* genome) {
    rater_->load(genome);
    const std::uint32_t for_mask = mask_ == MoveMask::RightOfWay ? 1u << kMustYield : 0;
    inputs_.want(rater_->reads() | for_mask);
}

void RatingPolicy::rate(const World& world, const Occupancy& occupancy) {
    inputs_.gather(world, occupancy);
    const int n = static_cast<int>(agents_.size());
    ratings_.resize(agents_.size());
    refused_.resize(agents_.size());
    for (int first = 0; first < n; first += kRatedAtOnce) {
        const int n_rated = std::min(n - first, kRatedAtOnce);
        for (int i = 0; i < n_rated; ++i) {
            inputs_.look(agents_[first + i], rows_[i]);
            refused_[first + i] = mask_ == MoveMask::None        ? 0
                                  : mask_ == MoveMask::Obstacles ? rows_[i].blocked
                                                                 : rows_[i].forbidden;
        }
        rater_->rate(rows_, n_rated, &ratings_[first]);
    }
}

// Lists the best of the allowed moves, and returns how many there are. Without branches: which move is
// best cannot be predicted.
template <int n_moves>
int RatingPolicy::list_best(std::size_t i, int* moves) const {
    const float (&ratings)[kMoveLanes] = ratings_[i].of;
    const std::uint32_t refused = refused_[i];
    float kept[n_moves];
    float most = ratings[0];  // nothing refuses to stay
    for (int move = 0; move < n_moves; ++move) {
        kept[move] = refused >> move & 1 ? -std::numeric_limits<float>::infinity() : ratings[move];
        most = kept[move] > most ? kept[move] : most;
    }
    int n = 0;
    for (int move = 0; move < n_moves; ++move) {
        moves[n] = move;
        n += kept[move] == most;
    }
    return n;
}

int RatingPolicy::list_best(std::size_t i, int* moves) const {
    return n_moves_ == kCompassMoves ? list_best<kCompassMoves>(i, moves)
                                     : list_best<kDiagonalMoves>(i, moves);
}

void RatingPolicy::choose(World& world, const Occupancy& occupancy) {
    rate(world, occupancy);
    for (std::size_t i = 0; i < agents_.size(); ++i) {
        int moves[kDiagonalMoves];
        const int n = list_best(i, moves);
        chosen_[i] = static_cast<std::uint8_t>(moves[below(draws_[i], n)]);
    }
}

// The order of right of way changes with the step.
bool RatingPolicy::counts_steps() const {
    return mask_ == MoveMask::RightOfWay || rater_->reads() >> kMustYield & 1;
}

void RatingPolicy::weigh(const World& world, const Occupancy& occupancy, double* out) {
    if (rater_->reads() >> kSearch & 1) {
        throw std::invalid_argument(
            "rating: expected one that decides by what it sees, the step and the episode, got one "
            "that reads search, which follows a plan");
    }
    rate(world, occupancy);
    for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
        int moves[kDiagonalMoves];
        const int n = list_best(agent, moves);
        std::fill_n(out, n_moves_, 0.0);
        for (int i = 0; i < n; ++i) out[moves[i]] = 1.0 / n;
        out += n_moves_;
    }
}

}  // namespace matrixworld
