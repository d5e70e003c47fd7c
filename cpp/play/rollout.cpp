#include "play/rollout.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace matrixworld {

namespace {

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
                pursuers.decide(world_, occupancy, first, std::min(last, n_pursuers),
                                actions_.data());
            }
            if (last > n_pursuers) {
                evaders.decide(world_, occupancy, std::max(first, n_pursuers), last,
                               actions_.data());
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

// Plays worlds of a match in the memory of one thread: in lockstep where that is possible, else one
// after the other.
class WorldsPlayer {
  public:
    WorldsPlayer(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
                 const Candidates& evaders, bool one_by_one) {
        if (!one_by_one && Lockstep::can_play(setup->config, pursuers, evaders)) {
            lockstep_.emplace(setup, pursuers, evaders);
        } else {
            workspace_.emplace(setup, pursuers, evaders);
        }
    }

    void play(const Match& match, std::int64_t first, std::int64_t last,
              const std::function<void()>& check, EpisodeStatistics* statistics) {
        if (lockstep_) return lockstep_->play(match, first, last, check, statistics);
        for (std::int64_t w = first; w < last; ++w) {
            *statistics++ = workspace_->play(
                match, static_cast<std::uint64_t>(w),
                [&](const World&, const Occupancy&, const std::vector<std::uint8_t>*) { check(); });
        }
    }

  private:
    std::optional<Lockstep> lockstep_;
    std::optional<Workspace> workspace_;
};

}  // namespace

std::vector<EpisodeStatistics> play_matches(const std::shared_ptr<const Setup>& setup,
                                            const Candidates& pursuers, const Candidates& evaders,
                                            const std::vector<Match>& matches, int n_worlds,
                                            int n_threads, const Workers::Poll& poll,
                                            bool one_by_one) {
    const auto n_matches = static_cast<std::int64_t>(matches.size());
    std::vector<EpisodeStatistics> statistics(count_episodes(matches.size(), n_worlds));
    const KeptWorkers kept(n_threads);
    Workers& workers = *kept;
    const std::int64_t pieces_per_match = (n_worlds + kWorldsPerPiece - 1) / kWorldsPerPiece;
    // A player is made by its thread's first piece: there may be fewer pieces than threads.
    std::vector<std::unique_ptr<WorldsPlayer>> players(
        static_cast<std::size_t>(workers.n_threads()));
    const auto play_piece = [&](std::int64_t piece, int thread) {
        std::unique_ptr<WorldsPlayer>& player = players[thread];
        if (!player) player = std::make_unique<WorldsPlayer>(setup, pursuers, evaders, one_by_one);
        const std::int64_t m = piece / pieces_per_match;
        const std::int64_t first = piece % pieces_per_match * kWorldsPerPiece;
        const std::int64_t last = std::min(first + kWorldsPerPiece, std::int64_t{n_worlds});
        player->play(
            matches[m], first, last, [&] { workers.check(thread); },
            &statistics[m * n_worlds + first]);
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
