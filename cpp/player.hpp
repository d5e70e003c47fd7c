// Who decides for a team: a network, or one of the scripted opponents.
#pragma once

#include <cstdint>
#include <vector>

#include "mlp.hpp"
#include "world.hpp"

namespace matrixworld {

// Random   any action, all equally likely
// Still    stays
// Chaser   the move after which the nearest adversary in view is nearest
// Fleer    the move after which the nearest adversary in view is farthest
// Chaser and fleer do not step into obstacles, break ties at random, and walk at
// random while they see nobody. Near is counted in moves.
enum class Script : std::uint8_t { Random, Still, Chaser, Fleer };

class Player {
  public:
    virtual ~Player() = default;

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

class NetworkPlayer : public Player {
  public:
    NetworkPlayer(const Network& network, const Grid& grid) : mlp_(network, grid) {}

    void load(const float* genome) { mlp_.load(genome); }

  private:
    void choose(const World& world, const Occupancy& occupancy) override;

    Mlp mlp_;
    std::vector<float> units_;
};

class ScriptedPlayer : public Player {
  public:
    ScriptedPlayer(Script script, int fov)
        : script_(script), view_(static_cast<std::size_t>(kChannels) * fov * fov) {}

  private:
    void choose(const World& world, const Occupancy& occupancy) override;
    std::uint8_t chase_or_flee(const World& world, const Occupancy& occupancy, int agent,
                               std::uint32_t draw);
    int distance_after(const World& world, Team adversary, int n_set, int move) const;

    Script script_;
    std::vector<int> view_;
};

}  // namespace matrixworld
