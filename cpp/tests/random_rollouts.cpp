// Plays rollouts of random worlds and policies under every combination of the rules, for a build with
// sanitizers: alone, where every moment is checked; by several threads; and in lockstep. The
// statistics of an episode are the same bits in all of them, and the sums of what its steps show.
//
//     random_rollouts [rounds]
#include <optional>

#include "invariants.hpp"

namespace matrixworld::tests {
namespace {

// The statistics of an episode, summed from what each of its steps shows.
class Tally {
  public:
    void add(const World& before, const World& after) {
        std::set<int> cells[kTeams];
        for (int a = 0; a < after.config().n_agents(); ++a) {
            const int t = static_cast<int>(after.team(a));
            sums_.agent_steps[t] += before.alive(a);
            sums_.returns[t] += static_cast<double>(after.rewards()[a]);
            for (int kind = 0; kind < kKinds; ++kind) {
                sums_.collisions[t * kKinds + kind] += after.report(a) >> kind & 1;
                sums_.faults[t * kKinds + kind] += after.report(a) >> (kKinds + kind) & 1;
            }
            if (after.alive(a)) n_overlapping_[t] += !cells[t].insert(after.cell(a)).second;
        }
        n_captured_ += n_captured(after);
        ++sums_.length;
    }

    EpisodeStatistics total(const World& last) const {
        const Config& config = last.config();
        const auto share = [](double count, int of) { return static_cast<float>(count / of); };
        EpisodeStatistics total = sums_;
        total.capture_rate = share(n_captured(last), config.n_evaders);
        total.ever_capture_rate = share(last.ever_captured().cast<int>().sum(), config.n_evaders);
        // The state at the end counts for the steps that were not played.
        const double captured = n_captured_ + (config.max_steps - sums_.length) * n_captured(last);
        total.captured_fraction = share(captured / config.max_steps, config.n_evaders);
        const int sizes[] = {config.n_pursuers, config.n_evaders};
        for (int t = 0; t < kTeams; ++t) {
            total.overlap[t] = share(n_overlapping_[t] / config.max_steps, sizes[t]);
        }
        for (int a = 0; a < config.n_agents(); ++a) {
            total.survivors[static_cast<int>(last.team(a))] += last.alive(a);
        }
        return total;
    }

  private:
    static int n_captured(const World& world) {
        int n = 0;
        for (int e = 0; e < world.config().n_evaders; ++e) n += counts_as_captured(world, e);
        return n;
    }

    EpisodeStatistics sums_;
    int n_captured_ = 0;
    double n_overlapping_[kTeams] = {};
};

// Plays an episode alone and checks all its moments.
EpisodeStatistics watch(const Game& game, const Match& match, int episode) {
    std::optional<World> before;
    Tally tally;
    const auto look = [&](const World& world, const Occupancy& occupancy,
                          const std::vector<std::uint8_t>* actions) {
        check_positions(world);
        check_counters(world);
        check_occupancy(world, occupancy, true);
        if (before) {
            check_moves(*before, world, *actions);
            check_apart(*before, world);
            tally.add(*before, world);
        }
        before.emplace(world);
    };
    const EpisodeStatistics statistics =
        play_episode(game.setup, game.pursuers->candidates, game.evaders->candidates, match,
                     static_cast<std::uint64_t>(episode), look);
    check_same(statistics, tally.total(*before));
    return statistics;
}

// The same for all episodes of all matches, (n matches, n_worlds).
std::vector<EpisodeStatistics> watch_all(const Game& game) {
    std::vector<EpisodeStatistics> all;
    for (const Match& match : game.matches) {
        for (int w = 0; w < game.n_worlds; ++w) all.push_back(watch(game, match, w));
    }
    return all;
}

void play_rollout(const Rules& rules, Random& random) {
    const int n_matches = random.between(1, 2);
    const int n_worlds = random.between(1, 20);
    const Game game = random_game(rules, n_matches, n_worlds, random);
    const auto alone = watch_all(game);
    check_same(alone, game.play(1));
    check_same(alone, game.play(3));
    check_same(alone, game.play(1, true));
}

// ---- Lockstep --------------------------------------------------------------------------------

// Half of them have teams that fill vectors, blocks and words of positions, or just do not.
Config lockstep_config(const Rules& rules, Random& random) {
    const auto size = [&] {
        return random.one_of({1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 33, 63, 64, 65, 127});
    };
    while (true) {
        Config config = random_config(rules, random);
        if (random.chance(50)) {
            config.n_pursuers = size();
            config.n_evaders = size();
        }
        const bool fits = !refused([&] { config.validate(); });
        if (fits && config.n_agents() <= kMaxPositions) return config;
    }
}

struct Interruption : std::exception {};

// A lockstep keeps its lanes and what its networks have summed from one call to the next, also when
// a call was interrupted. Each episode is still what it is alone.
void play_lockstep(const Rules& rules, Random& random) {
    if (rules.interaction == Interaction::AgentTurns) return;
    const Config config = lockstep_config(rules, random);
    const auto networks = [&] {
        const int n_hidden = random.between(1, 3);
        return random_networks(config, n_hidden, random);
    };
    const Game game{config, networks(), networks(), 2, random.one_of({1, 2, 3, 15, 16, 17, 33}),
                    random};
    const auto alone = watch_all(game);
    check_same(alone, game.play(1));
    Lockstep lockstep(game.setup, game.pursuers->candidates, game.evaders->candidates);
    for (int call = 0; call < 5; ++call) {
        const int m = random.below(2);
        const int first = random.below(game.n_worlds);
        const int last = random.between(first + 1, game.n_worlds);
        int n_rounds = random.chance(40) ? random.below(8) : -1;
        std::vector<EpisodeStatistics> played(static_cast<std::size_t>(last - first));
        const auto check = [&] {
            if (n_rounds-- == 0) throw Interruption();
        };
        try {
            lockstep.play(game.matches[m], first, last, check, played.data());
        } catch (const Interruption&) {
            continue;
        }
        for (int w = first; w < last; ++w) {
            check_same(played[w - first], alone[m * game.n_worlds + w]);
        }
    }
}

}  // namespace
}  // namespace matrixworld::tests

int main(int argc, char** argv) {
    using namespace matrixworld::tests;
    Random random(22);
    play_all("a rollout", play_rollout, argc, argv, random, 5);
    play_all("lockstep", play_lockstep, argc, argv, random, 5);
    return finish("random rollouts");
}
