// The statistics of an episode, accumulated while it is played. A new one is a member of
// EpisodeStatistics, its computation, and a row of `statistic_fields` in output_fields.cpp.
#pragma once

#include <array>
#include <cstdint>

#include "game/world.hpp"

namespace matrixworld {

// Means over steps are over max_steps. After an early end the share of captured evaders counts as it
// was at the end, and overlap counts as 0. A count that is too large for its type is reported as the
// largest number of the type.
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
    // Begins an episode in which all agents are alive.
    explicit StatisticsAccumulator(const Config& config);

    // To be called after every step. The occupancy must hold the world's agents.
    void add(const World& world, const Occupancy& occupancy);

    // The statistics of the episode, after its last step.
    EpisodeStatistics total(const World& world) const;

  private:
    void add_rewards(const World& world);

    EpisodeStatistics sums_;
    // Counts over steps. Whole numbers, so that a mean is rounded only once, at the end.
    std::int64_t n_captured_ = 0;  // evaders that count as captured, over steps
    std::array<std::int64_t, kTeams> n_overlapping_{};  // agents beyond the first on a cell
    std::array<std::int64_t, kTeams * kKinds> n_collisions_{};
    std::array<std::int64_t, kTeams * kKinds> n_faults_{};
    std::array<std::int64_t, kTeams> n_living_{};  // as the next step begins
};

}  // namespace matrixworld
