// Policies that rate moves: for each move the same function of its named inputs gives a number, and the
// agent takes the best move that is allowed; of equal ones any, all equally likely. What is learned for
// one direction so holds for all. The function is a small network, or a program (play/program.hpp).
//
//     RatingPolicy policy(shape, config);
//     policy.load(genome);
//     policy.decide(world, scratch.occupancy, first, last, actions);
//
// Every sum has one order, and products are rounded before they are added: a plain loop over float32
// in any language gives the same bits.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "observe/inputs.hpp"
#include "play/policy.hpp"

namespace matrixworld {

// So many agents look before they are rated at once, and their inputs stay in a core's cache.
constexpr int kRatedAtOnce = 8;

struct alignas(64) MoveRatings {
    float of[kMoveLanes];
};

// The function that a genome is. Genomes are loaded again and again, and used for many agents.
class MoveRater {
  public:
    virtual ~MoveRater() = default;

    // Reads a genome, which must stay in memory. Throws std::invalid_argument if it is none.
    virtual void load(const float* genome) = 0;
    // Rates all moves of n agents, at most kRatedAtOnce.
    virtual void rate(const MoveRows* rows, int n, MoveRatings* ratings) = 0;
    // The inputs that the genome reads, as bits by Input.
    virtual std::uint32_t reads() const = 0;
};

std::unique_ptr<MoveRater> make_rater(const RatingShape& shape);

class RatingPolicy : public Policy {
  public:
    RatingPolicy(const RatingShape& shape, const Config& config);

    void load(const float* genome) override;
    bool counts_steps() const override;
    bool draws_strides() const override { return rater_->reads() >> kAhead & 1; }

  private:
    void choose(World& world, const Occupancy& occupancy) override;
    void weigh(const World& world, const Occupancy& occupancy, double* out) override;
    void rate(const World& world, const Occupancy& occupancy);
    template <int n_moves>
    int list_best(std::size_t i, int* moves) const;
    int list_best(std::size_t i, int* moves) const;

    MoveInputs inputs_;
    MoveMask mask_;
    int n_moves_;
    std::unique_ptr<MoveRater> rater_;
    MoveRows rows_[kRatedAtOnce] = {};
    // By agent that acts: its ratings, and moves that the mask refuses, as bits.
    std::vector<MoveRatings> ratings_;
    std::vector<std::uint32_t> refused_;
};

}  // namespace matrixworld
