#include "play/episode_statistics.hpp"

#include <cmath>

namespace matrixworld {

namespace {

// Agents beyond the first on each cell, by team. Of k agents on one, each counts (k - 1) / k.
std::array<int, kTeams> overlaps(const World& world, const Occupancy& occupancy) {
    std::array<double, kTeams> sums{};
    const ReservationTable reservations = occupancy.reservations();
    for (int a : world.living()) {
        const Reservation reservation = reservations.at(world.cell(a), world.team(a));
        if (!reservation.several()) continue;
        const int n = reservation.count();
        sums[static_cast<int>(world.team(a))] += static_cast<double>(n - 1) / n;
    }
    return {static_cast<int>(std::lround(sums[0])), static_cast<int>(std::lround(sums[1]))};
}

// In four sums side by side, which need not wait for each other.
double sum(const float* values, int n) {
    constexpr int kSums = 4;
    double sums[kSums] = {};
    int i = 0;
    for (; i + kSums <= n; i += kSums) {
        for (int k = 0; k < kSums; ++k) sums[k] += values[i + k];
    }
    for (; i < n; ++i) sums[0] += values[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

StatisticsAccumulator::StatisticsAccumulator(const Config& config)
    : living_{config.n_pursuers, config.n_evaders} {}

void StatisticsAccumulator::add(const World& world, const Occupancy& occupancy) {
    const int sizes[kTeams] = {world.config().n_pursuers, world.config().n_evaders};
    const std::array<int, kTeams> overlapping = overlaps(world, occupancy);
    captured_ += world.n_captured();
    const float* rewards = world.rewards().data();
    for (int t = 0; t < kTeams; ++t) {
        overlapping_[t] += overlapping[t];
        score_.agent_steps[t] += living_[t];
        living_[t] = world.n_living(static_cast<Team>(t));
        score_.returns[t] += sum(rewards, sizes[t]);
        rewards += sizes[t];
    }
    for (int a = 0; a < world.config().n_agents(); ++a) {
        const Flags report = world.report(a);
        if (report == 0) continue;
        const int t = static_cast<int>(world.team(a));
        for (int kind = 0; kind < kKinds; ++kind) {
            score_.collisions[t * kKinds + kind] += report >> kind & 1;
            score_.faults[t * kKinds + kind] += report >> (kKinds + kind) & 1;
        }
    }
}

EpisodeStatistics StatisticsAccumulator::total(const World& world) const {
    const Config& config = world.config();
    const int sizes[kTeams] = {config.n_pursuers, config.n_evaders};
    const auto share = [](double count, int of) { return static_cast<float>(count / of); };
    const std::int64_t idle = config.max_steps - world.steps();
    const auto captured = static_cast<double>(captured_ + idle * world.n_captured());
    EpisodeStatistics score = score_;
    score.length = world.steps();
    score.capture_rate = share(world.n_captured(), config.n_evaders);
    score.ever_capture_rate = share(world.n_ever_captured(), config.n_evaders);
    score.captured_fraction = share(captured / config.max_steps, config.n_evaders);
    for (int t = 0; t < kTeams; ++t) {
        score.survivors[t] = world.n_living(static_cast<Team>(t));
        score.overlap[t] = share(static_cast<double>(overlapping_[t]) / config.max_steps, sizes[t]);
    }
    return score;
}

}  // namespace matrixworld
