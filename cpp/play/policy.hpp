// Who decides for a team: a network, or one of the scripted opponents.
#pragma once

#include <cstdint>
#include <vector>

#include "game/world.hpp"
#include "play/mlp.hpp"
#include "play/script.hpp"

namespace matrixworld {

class Policy {
  public:
    virtual ~Policy() = default;

    // Writes actions[agent] for the living agents [first, last), which are of one team.
    void decide(const World& world, const Occupancy& occupancy, int first, int last,
                std::vector<std::uint8_t>& actions);

  protected:
    // chosen_[i] for agents_[i], from draws_[i], 32 random bits of its own.
    virtual void choose(const World& world, const Occupancy& occupancy) = 0;

    std::vector<int> agents_;
    std::vector<std::uint32_t> draws_;
    std::vector<std::uint8_t> chosen_;
};

class NetworkPolicy : public Policy {
  public:
    NetworkPolicy(const Network& network, const Grid& grid) : mlp_(network, grid) {}

    void load(const float* genome) { mlp_.load(genome); }

  private:
    void choose(const World& world, const Occupancy& occupancy) override;

    Mlp mlp_;
    std::vector<float> units_;
};

class ScriptedPolicy : public Policy {
  public:
    ScriptedPolicy(const Script& script, int fov) : script_(script), sight_(fov) {}

  private:
    void choose(const World& world, const Occupancy& occupancy) override;
    int best_move(const World& world, const Occupancy& occupancy, int agent, std::uint32_t draw);
    int walk_on(const World& world, int agent) const;

    const Script& script_;
    Sight sight_;
    Offsets goals_;
};

}  // namespace matrixworld
