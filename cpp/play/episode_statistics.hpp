// What an episode comes to, added up as it is played.
#pragma once

#include <array>
#include <cstdint>

#include "game/world.hpp"

namespace matrixworld {

// Means over steps are over max_steps; after an early end the share of captured evaders stands as
// it was, and overlap counts 0.
struct EpisodeStatistics {
    float capture_rate = 0;                // share of the evaders that count as captured at the end
    float ever_capture_rate = 0;           // share of the evaders captured at some time
    float captured_fraction = 0;           // share that counts as captured, mean over steps
    std::int32_t length = 0;               // steps
    std::array<double, kTeams> returns{};  // rewards summed over team and steps
    std::array<std::int32_t, kTeams> survivors{};
    std::array<float, kTeams> overlap{};  // (alive - distinct cells) / team size, mean
    std::array<std::int32_t, kTeams * kKinds> collisions{};  // agent-steps involved, by team, kind
    std::array<std::int32_t, kTeams * kKinds> faults{};      // agent-steps at fault
    std::array<std::int64_t, kTeams> agent_steps{};          // steps by agents alive as they began
};

class StatisticsAccumulator {
  public:
    // Begins an episode in which everybody is alive.
    explicit StatisticsAccumulator(const Config& config);

    // After every step. The agents must be in the occupancy.
    void add(const World& world, const Occupancy& occupancy);

    EpisodeStatistics total(const World& world) const;

  private:
    EpisodeStatistics score_;
    std::int64_t captured_ = 0;
    std::array<std::int64_t, kTeams> overlapping_{};
    std::array<std::int64_t, kTeams> living_{};  // as the next step begins
};

}  // namespace matrixworld
