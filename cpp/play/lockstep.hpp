// A match between networks in lockstep: its worlds play a round together, so that a network decides
// for the agents of all worlds at once. Its weights are then read once for many agents, and vectors
// are full where a single world has few agents left. Each episode is what it is when played alone.
//
//     Lockstep lockstep(setup, pursuers, evaders);              // one for each thread
//     lockstep.play(match, 0, 16, [] {}, statistics);           // episodes 0 to 15 of its seed
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "game/world.hpp"
#include "observe/crowd.hpp"
#include "play/episode_statistics.hpp"
#include "play/mlp.hpp"
#include "play/policy.hpp"

namespace matrixworld {

struct Match {
    int pursuer;  // number of the pursuers' candidate
    int evader;   // number of the evaders' candidate
    std::uint64_t seed;
};

class Lockstep {
  public:
    // Both teams need networks with a hidden layer, and the agents of a team must act together.
    static bool can_play(const Config& config, const Candidates& pursuers,
                         const Candidates& evaders);

    Lockstep(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
             const Candidates& evaders);

    // Plays the episodes [first, last) of a match and writes the statistics of each. Calls `check`
    // in every round; when it throws, the episodes end there.
    void play(const Match& match, std::int64_t first, std::int64_t last,
              const std::function<void()>& check, EpisodeStatistics* statistics);

  private:
    // A world with what is kept for it from round to round.
    struct Lane {
        Lane(const std::shared_ptr<const Setup>& setup, std::size_t number);

        // The range of a team among the living.
        int first(Team team) const {
            return team == Team::Pursuer ? 0 : world.n_living(Team::Pursuer);
        }
        int last(Team team) const { return first(team) + world.n_living(team); }

        std::size_t number;
        World world;
        Crowd crowd;
        StatisticsAccumulator accumulator;
        std::vector<float> units;           // by agent
        std::vector<std::uint8_t> actions;  // by agent
        EpisodeStatistics* statistics = nullptr;
    };

    // A team's network, which decides for all lanes: each agent has a row of its layers.
    class Squad {
      public:
        Squad(const Candidates& candidates, const Setup& setup, Team team);

        void load(int candidate);
        void forget() { holders_.clear(); }
        void decide(const std::vector<Lane*>& lanes);

      private:
        void recall(const std::vector<Lane*>& lanes, std::size_t n);

        const Candidates& candidates_;
        Team team_;
        Mlp mlp_;
        int loaded_ = -1;                    // candidate
        std::vector<float> units_;           // by row
        std::vector<std::uint8_t> actions_;  // by row
        std::vector<int> holders_;           // by row: whose memory lies there
    };

    void enter(Lane& lane, EpisodeKey key, EpisodeStatistics* statistics);
    void play_round();
    void play_turn(Lane& lane, int turn);
    void drop_ended();

    std::shared_ptr<const Setup> setup_;
    Scratch scratch_;
    Squad pursuers_;
    Squad evaders_;
    std::vector<std::unique_ptr<Lane>> lanes_;
    std::vector<Lane*> playing_;  // the lanes whose episodes have not ended
};

}  // namespace matrixworld
