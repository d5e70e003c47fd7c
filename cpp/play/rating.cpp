#include "play/rating.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>

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
        std::size_t widest = 0;
        for (const int size : shape.hidden) {
            widest = std::max(widest, static_cast<std::size_t>(size));
        }
        for (auto& layer : units_) layer.resize(widest);
    }

    void load(const float* genome) override {
        genome_ = genome;
        const int width = shape_.hidden.empty() ? 1 : shape_.hidden.front();
        reads_ = 0;
        used_.clear();
        for (std::size_t i = 0; i < shape_.inputs.size(); ++i) {
            const float* const row = genome + i * width;
            if (std::all_of(row, row + width, [](float weight) { return weight == 0; })) continue;
            reads_ |= 1u << shape_.inputs[i];
            used_.push_back({shape_.inputs[i], static_cast<int>(i)});
        }
    }

    void rate(const Inputs& inputs, Inputs::Row& ratings) override {
        if (n_words(inputs) == 2) {
            rate<2>(inputs, ratings);
        } else {
            rate<3>(inputs, ratings);
        }
    }

    std::uint32_t reads() const override { return reads_; }

  private:
    using Vec = Lanes<float, 4>;
    struct Used {
        int input;
        int place;  // in the genome
    };
    struct Unit {
        alignas(16) Inputs::Row by_move;
    };

    static int n_words(const Inputs& inputs) { return inputs.n_moves() == kCompassMoves ? 2 : 3; }

    // sum += weight * x for all moves, each product rounded before it is added.
    template <int n>
    static void add(float weight, const Inputs::Row& x, Vec (&sum)[n]) {
        for (int i = 0; i < n; ++i) {
            Vec part;
            std::memcpy(&part, x + 4 * i, sizeof(part));
            sum[i] += part * splat<Vec>(weight);
        }
    }

    template <int n>
    static void write(const Vec (&sum)[n], float least, Inputs::Row& out) {
        for (int i = 0; i < n; ++i) {
            const Vec floor = splat<Vec>(least);
            const Vec kept = where(sum[i] > floor, sum[i], floor);
            std::memcpy(out + 4 * i, &kept, sizeof(kept));
        }
    }

    template <int n>
    void rate(const Inputs& inputs, Inputs::Row& ratings) {
        const float* weights = genome_;
        int n_in = static_cast<int>(shape_.inputs.size());
        for (std::size_t layer = 0; layer < shape_.hidden.size(); ++layer) {
            const int n_out = shape_.hidden[layer];
            const float* const biases = weights + static_cast<std::ptrdiff_t>(n_in) * n_out;
            const std::vector<Unit>& in = units_[(layer + 1) % 2];
            for (int unit = 0; unit < n_out; ++unit) {
                Vec sum[n];
                for (Vec& part : sum) part = splat<Vec>(biases[unit]);
                if (layer == 0) {
                    for (const auto& [input, place] : used_)
                        add<n>(weights[place * n_out + unit], inputs.of(input), sum);
                } else {
                    for (int i = 0; i < n_in; ++i)
                        add<n>(weights[static_cast<std::ptrdiff_t>(i) * n_out + unit],
                               in[i].by_move, sum);
                }
                write<n>(sum, 0, units_[layer % 2][unit].by_move);
            }
            weights = biases + n_out;
            n_in = n_out;
        }
        Vec sum[n];
        for (Vec& part : sum) part = splat<Vec>(0.0f);
        if (shape_.hidden.empty()) {
            for (const auto& [input, place] : used_) add<n>(weights[place], inputs.of(input), sum);
        } else {
            const std::vector<Unit>& in = units_[(shape_.hidden.size() + 1) % 2];
            for (int i = 0; i < n_in; ++i) add<n>(weights[i], in[i].by_move, sum);
        }
        write<n>(sum, std::numeric_limits<float>::lowest(), ratings);
    }

    RatingShape shape_;
    const float* genome_ = nullptr;
    std::uint32_t reads_ = 0;
    std::vector<Used> used_;      // inputs with a weight that is not 0
    std::vector<Unit> units_[2];  // of layers in turn
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

// Lists the best of the allowed moves, and returns how many there are. No rating is below that of
// what is no number, the lowest one. Without branches: which move is best cannot be predicted.
int RatingPolicy::list_best(int agent, int* moves) {
    inputs_.look(agent);
    rater_->rate(inputs_, ratings_);
    const std::uint32_t refused = mask_ == MoveMask::None        ? 0
                                  : mask_ == MoveMask::Obstacles ? inputs_.blocked()
                                                                 : inputs_.forbidden();
    float most = ratings_[0];
    for (int move = 1; move < n_moves_; ++move) {
        const float rating = refused >> move & 1 ? ratings_[0] : ratings_[move];
        most = rating > most ? rating : most;
    }
    int n = 0;
    for (int move = 0; move < n_moves_; ++move) {
        moves[n] = move;
        n += ratings_[move] == most && !(refused >> move & 1);
    }
    return n;
}

void RatingPolicy::choose(World& world, const Occupancy& occupancy) {
    inputs_.gather(world, occupancy);
    for (std::size_t i = 0; i < agents_.size(); ++i) {
        int moves[kDiagonalMoves];
        const int n = list_best(agents_[i], moves);
        chosen_[i] = static_cast<std::uint8_t>(moves[below(draws_[i], n)]);
    }
}

void RatingPolicy::weigh(const World& world, const Occupancy& occupancy, double* out) {
    const std::uint32_t by_step = 1u << kMustYield | 1u << kAhead;
    if (mask_ == MoveMask::RightOfWay || rater_->reads() & by_step) {
        throw std::invalid_argument(
            "rating: expected one that decides by what it sees alone, got one that reads ahead or "
            "must_yield, or has the mask right-of-way, which count steps");
    }
    inputs_.gather(world, occupancy);
    for (const int agent : agents_) {
        int moves[kDiagonalMoves];
        const int n = list_best(agent, moves);
        std::fill_n(out, n_moves_, 0.0);
        for (int i = 0; i < n; ++i) out[moves[i]] = 1.0 / n;
        out += n_moves_;
    }
}

}  // namespace matrixworld
