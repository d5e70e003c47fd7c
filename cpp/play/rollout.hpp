// Rollouts: matches -> episode statistics. Whole episodes of one team's candidates against the other
// team's, without leaving C++. A pure function of its arguments: world j of a match is episode j of
// the match's seed, and no result depends on the number of threads or on the other matches.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "game/world.hpp"
#include "play/episode_statistics.hpp"
#include "play/lockstep.hpp"
#include "play/policy.hpp"
#include "play/threads.hpp"

namespace matrixworld {

// Called after the reset, with null actions, and after every step, with the actions (A,) of it.
// The occupancy holds the world's agents.
using StepCallback = std::function<void(const World& world, const Occupancy& occupancy,
                                        const std::vector<std::uint8_t>* actions)>;

// Plays n_worlds episodes of every match and returns their statistics, (n matches, n_worlds), flat: in
// lockstep where that is possible, unless they are to be played `one_by_one`, which gives the same
// bits and is what tests compare with. The calling thread calls `poll` about every 50 ms; if that
// throws, all threads stop after their round, and the exception leaves this function. Throws
// std::invalid_argument for more episodes than memory can hold.
std::vector<EpisodeStatistics> play_matches(const std::shared_ptr<const Setup>& setup,
                                            const Candidates& pursuers, const Candidates& evaders,
                                            const std::vector<Match>& matches, int n_worlds,
                                            int n_threads, const Workers::Poll& poll = {},
                                            bool one_by_one = false);

// Plays one of these episodes and calls `callback` at each of its moments.
EpisodeStatistics play_episode(const std::shared_ptr<const Setup>& setup,
                               const Candidates& pursuers, const Candidates& evaders,
                               const Match& match, std::uint64_t episode,
                               const StepCallback& callback);

}  // namespace matrixworld
