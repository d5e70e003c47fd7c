// Policies choose a team's actions: a neural network, or one of the scripted opponents.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/world.hpp"
#include "observe/right_of_way.hpp"
#include "play/mlp.hpp"
#include "play/script.hpp"

namespace matrixworld {

class Policy {
  public:
    virtual ~Policy() = default;

    // Reads a genome, which must stay in memory. Not for policies that have none.
    virtual void load(const float*) {}

    // Writes actions[agent] for the living agents in [first, last), which belong to one team, and what
    // they remember from this step.
    template <typename Integer>
    void decide(World& world, const Occupancy& occupancy, int first, int last, Integer* actions) {
        draw(world, first, last);
        if (agents_.empty()) return;
        choose(world, occupancy);
        for (std::size_t i = 0; i < agents_.size(); ++i) actions[agents_[i]] = chosen_[i];
    }

    // Writes the probabilities with which `decide` would choose each action, (n living agents in
    // [first, last), n_actions): a network's are the softmax of its outputs, or 1 for the largest
    // one. Throws std::invalid_argument where choices depend on more than the present moment, its
    // step and its episode.
    void weigh(const World& world, const Occupancy& occupancy, int first, int last, double* out) {
        draw(world, first, last);
        if (!agents_.empty()) weigh(world, occupancy, out);
    }

    // Do its choices in a moment differ from step to step, or by what each episode draws?
    virtual bool counts_steps() const { return false; }
    virtual bool draws_strides() const { return false; }

  protected:
    // Writes chosen_[i] for each agents_[i]. Called once for all agents of a turn, not once for each,
    // so that a network reads its weights once and the virtual call costs nothing.
    virtual void choose(World& world, const Occupancy& occupancy) = 0;
    virtual void weigh(const World& world, const Occupancy& occupancy, double* out) = 0;

    std::vector<int> agents_;           // the living agents that act, ascending
    std::vector<std::uint32_t> draws_;  // by agent that acts: 32 random bits
    std::vector<std::uint8_t> chosen_;  // by agent that acts: its action

  private:
    void draw(const World& world, int first, int last);
};

class NetworkPolicy : public Policy {
  public:
    NetworkPolicy(const Network& network, const Grid& grid) : mlp_(network, grid) {}

    void load(const float* genome) override { mlp_.load(genome); }

  private:
    void choose(World& world, const Occupancy& occupancy) override;
    void weigh(const World& world, const Occupancy& occupancy, double* out) override;

    Mlp mlp_;
    std::vector<float> units_;  // the draws as numbers in [0, 1)
};

class ScriptedPolicy : public Policy {
  public:
    ScriptedPolicy(const Script& script, const Config& config);

    bool counts_steps() const override { return script_.careful; }

  private:
    void choose(World& world, const Occupancy& occupancy) override;
    void weigh(const World& world, const Occupancy& occupancy, double* out) override;
    void look(const World& world, const Occupancy& occupancy, int agent);
    bool walks() const { return goals_.empty() && script_.stride > 0; }
    bool allows(const World& world, const Occupancy& occupancy, int agent, int move) const;
    int find_best(const World& world, const Occupancy& occupancy, int agent, int* moves) const;
    int best_move(const World& world, const Occupancy& occupancy, int agent, std::uint32_t draw);
    int list_slips(const World& world, const Occupancy& occupancy, int agent, int* moves) const;

    const Script& script_;
    Sight sight_;
    std::vector<RightOfWay> ways_;  // by team; empty unless the script is careful
    Offsets goals_;                 // of the agent that decides
    int rates_[kDiagonalMoves];     // of the moves of the agent that decides, if the script rates
};

// Which moves are never taken: none; those into an obstacle or the border; those that right of way
// forbids (observe/right_of_way.hpp).
enum class MoveMask : std::uint8_t { None, Obstacles, RightOfWay };
// "none", "obstacles" or "right-of-way". Throws std::invalid_argument for other names.
MoveMask to_mask(const std::string& name);

// The shape of a policy that rates moves (play/rating.hpp): a network of `hidden` layers, or programs
// of at most `length` instructions.
struct RatingShape {
    int fov = 0;
    int n_actions = 0;
    std::vector<int> inputs;  // by Input, in the order of the genome
    std::vector<int> hidden;  // of a network; none: a weighted sum of the inputs
    int length = 0;           // of programs; 0: a network
    MoveMask mask = MoveMask::None;

    Eigen::Index genome_size() const;
    // These throw std::invalid_argument: for numbers that no policy has, for a world with other
    // views or moves, and where one of n genomes is no program.
    void validate() const;
    void check_fits(const std::string& name, const Config& config) const;
    void check_genomes(const float* genomes, std::size_t n) const;
};

// One team's candidates: n genomes of one network or rating, one script, or any other policy.
struct Candidates {
    std::optional<Network> network;
    std::optional<RatingShape> rating;
    const float* genomes = nullptr;  // (n, genome_size), owned by the caller
    int n = 1;
    const Script* script = nullptr;                 // without genomes
    std::function<std::unique_ptr<Policy>()> make;  // without both

    // Does anything play?
    explicit operator bool() const { return genomes || script || make; }
};

// Draws for each agent of a world, alive or gone, the number in [0, 1) with which a policy that
// samples decides in this round. Precondition: `units` has room for a multiple of kAgentsPerBlock.
constexpr int kAgentsPerBlock = 2 * kDrawsPerBlock;  // 32 bits of a block for each
void draw_units(const World& world, float* units);

// The policy of candidates, which must stay in memory. It keeps the genome that it read last, because
// a thread mostly plays several worlds with the same genome one after the other.
class LoadedPolicy {
  public:
    LoadedPolicy(const Candidates& candidates, const Setup& setup);

    Policy& load(int candidate);

  private:
    const Candidates* candidates_;
    std::unique_ptr<Policy> policy_;
    Eigen::Index genome_size_ = 0;  // without genomes: 0
    int loaded_ = -1;
};

}  // namespace matrixworld
