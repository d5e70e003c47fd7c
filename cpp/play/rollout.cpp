#include "play/rollout.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace matrixworld {

namespace {

// Enough worlds that taking a piece costs nothing, few enough that threads end at the same time.
constexpr std::int64_t kWorldsPerPiece = 16;

// A team's policy in the memory of one thread. It keeps the genome that it read last, because the
// pieces that a thread takes one after the other mostly belong to the same match.
class LoadedPolicy {
  public:
    LoadedPolicy(const Candidates& candidates, const Setup& setup) : candidates_(candidates) {
        if (candidates.network) {
            auto policy = std::make_unique<NetworkPolicy>(*candidates.network, setup.grid);
            network_ = policy.get();
            policy_ = std::move(policy);
        } else {
            policy_ = std::make_unique<ScriptedPolicy>(*candidates.script, setup.config.fov);
        }
    }

    Policy& load(int candidate) {
        if (network_ && candidate != loaded_) {
            network_->load(candidates_.genomes + candidate * candidates_.network->genome_size());
            loaded_ = candidate;
        }
        return *policy_;
    }

  private:
    const Candidates& candidates_;
    std::unique_ptr<Policy> policy_;
    NetworkPolicy* network_ = nullptr;  // the policy, unless it is a script
    int loaded_ = -1;
};

// The memory of one thread: a world, its scratch and both teams' policies.
class Workspace {
  public:
    Workspace(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
              const Candidates& evaders)
        : world_(setup),
          scratch_(*setup),
          pursuers_(pursuers, *setup),
          evaders_(evaders, *setup),
          actions_(static_cast<std::size_t>(setup->config.n_agents()), 0) {}

    EpisodeStatistics play(const Match& match, std::uint64_t episode,
                           const StepCallback& callback) {
        world_.reset({match.seed, episode}, scratch_);
        Policy& pursuers = pursuers_.load(match.pursuer);
        Policy& evaders = evaders_.load(match.evader);
        StatisticsAccumulator statistics(world_.config());
        callback(world_, scratch_.occupancy, nullptr);
        while (!world_.over()) {
            play_round(pursuers, evaders);
            statistics.add(world_, scratch_.occupancy);
            callback(world_, scratch_.occupancy, &actions_);
        }
        world_.leave(scratch_);
        return statistics.total(world_);
    }

  private:
    // The agents of a turn decide at its beginning, so they see what earlier turns of the round
    // did. A turn's actors may belong to one team or to both.
    void play_round(Policy& pursuers, Policy& evaders) {
        const int n_pursuers = world_.config().n_pursuers;
        world_.begin_round();
        for (int turn = 0; turn < world_.n_turns() && !world_.terminated(); ++turn) {
            int first = 0;
            int last = 0;
            world_.actors(turn, first, last);
            const Occupancy& occupancy = scratch_.occupancy;
            if (first < n_pursuers) {
                pursuers.decide(world_, occupancy, first, std::min(last, n_pursuers), actions_);
            }
            if (last > n_pursuers) {
                evaders.decide(world_, occupancy, std::max(first, n_pursuers), last, actions_);
            }
            world_.play_turn(turn, actions_.data(), scratch_);
        }
        world_.end_round();
    }

    World world_;
    Scratch scratch_;
    LoadedPolicy pursuers_;
    LoadedPolicy evaders_;
    std::vector<std::uint8_t> actions_;
};

// The number of episodes of all matches, if a list of so many statistics can exist at all.
std::size_t count_episodes(std::size_t n_matches, int n_worlds) {
    if (n_worlds < 1) {
        throw std::invalid_argument("worlds: expected at least 1, got " + std::to_string(n_worlds));
    }
    const auto worlds = static_cast<std::size_t>(n_worlds);
    const std::size_t most = std::vector<EpisodeStatistics>().max_size() / worlds;
    if (n_matches <= most) return n_matches * worlds;
    throw std::invalid_argument("matches: expected at most " + std::to_string(most) + " of " +
                                std::to_string(n_worlds) + " worlds, got " +
                                std::to_string(n_matches));
}

}  // namespace

std::vector<EpisodeStatistics> play_matches(const std::shared_ptr<const Setup>& setup,
                                            const Candidates& pursuers, const Candidates& evaders,
                                            const std::vector<Match>& matches, int n_worlds,
                                            int n_threads, const Workers::Poll& poll) {
    const auto n_matches = static_cast<std::int64_t>(matches.size());
    const std::int64_t pieces_per_match = (n_worlds + kWorldsPerPiece - 1) / kWorldsPerPiece;
    std::vector<EpisodeStatistics> statistics(count_episodes(matches.size(), n_worlds));
    Workers workers(n_threads);
    // A workspace is made by its thread's first piece: there may be fewer pieces than threads.
    std::vector<std::unique_ptr<Workspace>> workspaces(
        static_cast<std::size_t>(workers.n_threads()));
    const auto play_piece = [&](std::int64_t piece, int thread) {
        std::unique_ptr<Workspace>& workspace = workspaces[thread];
        if (!workspace) workspace = std::make_unique<Workspace>(setup, pursuers, evaders);
        const StepCallback check = [&](const World&, const Occupancy&,
                                       const std::vector<std::uint8_t>*) { workers.check(thread); };
        const std::int64_t m = piece / pieces_per_match;
        const std::int64_t begin = piece % pieces_per_match * kWorldsPerPiece;
        const std::int64_t end = std::min(begin + kWorldsPerPiece, std::int64_t{n_worlds});
        for (std::int64_t w = begin; w < end; ++w) {
            statistics[m * n_worlds + w] =
                workspace->play(matches[m], static_cast<std::uint64_t>(w), check);
        }
    };
    workers.run(n_matches * pieces_per_match, play_piece, poll);
    return statistics;
}

EpisodeStatistics play_episode(const std::shared_ptr<const Setup>& setup,
                               const Candidates& pursuers, const Candidates& evaders,
                               const Match& match, std::uint64_t episode,
                               const StepCallback& callback) {
    return Workspace(setup, pursuers, evaders).play(match, episode, callback);
}

}  // namespace matrixworld
