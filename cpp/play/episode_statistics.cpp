#include "play/episode_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace matrixworld {

namespace {

// Agents beyond the first on each cell, by team. Each of k agents on a cell adds (k - 1) / k: so
// no cell has to be marked as counted. The sum is a whole number, up to rounding.
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

std::int32_t at_most_int32(std::int64_t count) {
    return static_cast<std::int32_t>(std::min<std::int64_t>(count, INT32_MAX));
}

// Four sums side by side, because each addition of one sum waits for the one before it.
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
    : n_living_{config.n_pursuers, config.n_evaders} {}

void StatisticsAccumulator::add(const World& world, const Occupancy& occupancy) {
    n_captured_ += world.n_captured();
    add_rewards(world);
    if (world.may_overlap()) {
        const std::array<int, kTeams> overlapping = overlaps(world, occupancy);
        for (int t = 0; t < kTeams; ++t) n_overlapping_[t] += overlapping[t];
    }
    for (int t = 0; t < kTeams; ++t) {
        sums_.agent_steps[t] += n_living_[t];
        n_living_[t] = world.n_living(static_cast<Team>(t));
    }
    for (int a : world.reported()) {
        const Flags report = world.report(a);
        const int t = static_cast<int>(world.team(a));
        for (int kind = 0; kind < kKinds; ++kind) {
            n_collisions_[t * kKinds + kind] += report >> kind & 1;
            n_faults_[t * kKinds + kind] += report >> (kKinds + kind) & 1;
        }
    }
}

// Where all agents were paid the same, the product is their sum: a double holds both exactly.
void StatisticsAccumulator::add_rewards(const World& world) {
    const int sizes[kTeams] = {world.config().n_pursuers, world.config().n_evaders};
    const float* rewards = world.rewards().data();
    for (int t = 0; t < kTeams; ++t) {
        const double step = world.config().rewards.step[t];
        sums_.returns[t] += world.paid_steps_only() ? step * static_cast<double>(n_living_[t])
                                                    : sum(rewards, sizes[t]);
        rewards += sizes[t];
    }
}

EpisodeStatistics StatisticsAccumulator::total(const World& world) const {
    const Config& config = world.config();
    const int sizes[kTeams] = {config.n_pursuers, config.n_evaders};
    const auto share = [](double count, int of) { return static_cast<float>(count / of); };
    // Steps that were not played because the episode ended early.
    const std::int64_t idle = config.max_steps - world.steps();
    const auto captured = static_cast<double>(n_captured_ + idle * world.n_captured());
    EpisodeStatistics statistics = sums_;
    statistics.length = world.steps();
    statistics.capture_rate = share(world.n_captured(), config.n_evaders);
    statistics.ever_capture_rate = share(world.n_ever_captured(), config.n_evaders);
    statistics.captured_fraction = share(captured / config.max_steps, config.n_evaders);
    for (int i = 0; i < kTeams * kKinds; ++i) {
        statistics.collisions[i] = at_most_int32(n_collisions_[i]);
        statistics.faults[i] = at_most_int32(n_faults_[i]);
    }
    for (int t = 0; t < kTeams; ++t) {
        statistics.survivors[t] = world.n_living(static_cast<Team>(t));
        statistics.overlap[t] =
            share(static_cast<double>(n_overlapping_[t]) / config.max_steps, sizes[t]);
    }
    return statistics;
}

}  // namespace matrixworld
