#include "play/rollout.hpp"

#include <algorithm>

#include "play/threads.hpp"

namespace matrixworld {

namespace {

constexpr int kWorldsPerPiece = 16;

// A team's seat at a thread: keeps the player ready for the candidate that it played last.
class Seat {
  public:
    Seat(const Candidates& candidates, const Setup& setup) : candidates_(candidates) {
        if (candidates.network) {
            auto player = std::make_unique<NetworkPolicy>(*candidates.network, setup.grid);
            network_ = player.get();
            player_ = std::move(player);
        } else {
            player_ = std::make_unique<ScriptedPolicy>(*candidates.script, setup.config.fov);
        }
    }

    Policy& take(int candidate) {
        if (network_ && candidate != loaded_) {
            network_->load(candidates_.genomes + candidate * candidates_.network->genome_size());
            loaded_ = candidate;
        }
        return *player_;
    }

  private:
    const Candidates& candidates_;
    std::unique_ptr<Policy> player_;
    NetworkPolicy* network_ = nullptr;
    int loaded_ = -1;
};

// A thread's place to play: a world, its scratch and a seat for each team.
class Table {
  public:
    Table(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
          const Candidates& evaders)
        : world_(setup),
          scratch_(*setup),
          pursuers_(pursuers, *setup),
          evaders_(evaders, *setup),
          actions_(static_cast<std::size_t>(setup->config.n_agents()), 0) {}

    EpisodeStatistics play(const Match& match, std::uint64_t episode, const Watcher* watcher) {
        world_.reset({match.seed, episode}, scratch_);
        Policy& pursuers = pursuers_.take(match.pursuer);
        Policy& evaders = evaders_.take(match.evader);
        StatisticsAccumulator tally(world_.config());
        if (watcher) (*watcher)(world_, nullptr);
        while (!world_.over()) {
            play_round(pursuers, evaders);
            tally.add(world_, scratch_.occupancy);
            if (watcher) (*watcher)(world_, &actions_);
        }
        world_.leave(scratch_);
        return tally.total(world_);
    }

  private:
    // Everybody looks when its turn comes, and sees what was done before in the round.
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
    Seat pursuers_;
    Seat evaders_;
    std::vector<std::uint8_t> actions_;
};

}  // namespace

std::vector<EpisodeStatistics> play_matches(const std::shared_ptr<const Setup>& setup,
                                            const Candidates& pursuers, const Candidates& evaders,
                                            const std::vector<Match>& matches, int n_worlds,
                                            int n_threads) {
    const int n_matches = static_cast<int>(matches.size());
    const int pieces_per_match = (n_worlds + kWorldsPerPiece - 1) / kWorldsPerPiece;
    std::vector<EpisodeStatistics> scores(matches.size() * static_cast<std::size_t>(n_worlds));
    Workers workers(n_threads);
    std::vector<std::unique_ptr<Table>> tables(static_cast<std::size_t>(workers.n_threads()));
    workers.run(n_matches * pieces_per_match, [&](int piece, int thread) {
        if (!tables[thread]) tables[thread] = std::make_unique<Table>(setup, pursuers, evaders);
        const int m = piece / pieces_per_match;
        const int begin = piece % pieces_per_match * kWorldsPerPiece;
        for (int w = begin; w < std::min(begin + kWorldsPerPiece, n_worlds); ++w) {
            scores[static_cast<std::size_t>(m) * n_worlds + w] =
                tables[thread]->play(matches[m], static_cast<std::uint64_t>(w), nullptr);
        }
    });
    return scores;
}

EpisodeStatistics watch_match(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
                              const Candidates& evaders, const Match& match, std::uint64_t episode,
                              const Watcher& watcher) {
    return Table(setup, pursuers, evaders).play(match, episode, &watcher);
}

}  // namespace matrixworld
