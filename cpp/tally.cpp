#include "tally.hpp"

#include <cmath>

namespace matrixworld {

namespace {

// Agents beyond the first on each cell. Of k agents on one, each counts (k - 1) / k.
int crowd(const World& world, const Occupancy& occupancy, Team team) {
    double sum = 0;
    for (int a : world.living()) {
        if (world.team(a) != team) continue;
        const int n = occupancy.count(world.cell(a), team);
        if (n > 1) sum += static_cast<double>(n - 1) / n;
    }
    return static_cast<int>(std::lround(sum));
}

}  // namespace

Tally::Tally(const Config& config) : living_{config.n_pursuers, config.n_evaders} {}

void Tally::add(const World& world, const Occupancy& occupancy) {
    captured_ += world.n_captured();
    for (int t = 0; t < kTeams; ++t) {
        const Team team = static_cast<Team>(t);
        crowded_[t] += crowd(world, occupancy, team);
        score_.agent_steps[t] += living_[t];
        living_[t] = world.n_living(team);
    }
    for (int a = 0; a < world.config().n_agents(); ++a) {
        const int t = static_cast<int>(world.team(a));
        score_.returns[t] += world.rewards()[a];
        const Flags report = world.report(a);
        if (report == 0) continue;
        for (int kind = 0; kind < kKinds; ++kind) {
            score_.collisions[t * kKinds + kind] += report >> kind & 1;
            score_.faults[t * kKinds + kind] += report >> (kKinds + kind) & 1;
        }
    }
}

Score Tally::total(const World& world) const {
    const Config& config = world.config();
    const int sizes[kTeams] = {config.n_pursuers, config.n_evaders};
    const auto share = [](double count, int of) { return static_cast<float>(count / of); };
    const std::int64_t idle = config.max_steps - world.steps();
    const auto captured = static_cast<double>(captured_ + idle * world.n_captured());
    Score score = score_;
    score.length = world.steps();
    score.capture_rate = share(world.n_captured(), config.n_evaders);
    score.ever_capture_rate = share(world.n_ever_captured(), config.n_evaders);
    score.captured_fraction = share(captured / config.max_steps, config.n_evaders);
    for (int t = 0; t < kTeams; ++t) {
        score.survivors[t] = world.n_living(static_cast<Team>(t));
        score.crowding[t] = share(static_cast<double>(crowded_[t]) / config.max_steps, sizes[t]);
    }
    return score;
}

}  // namespace matrixworld
