// Matches -> scores: whole episodes of one team's genomes against another's, without leaving C++.
// A pure function of its arguments: world j of a match is episode j of the match's seed, and no
// result depends on the number of threads or on the other matches.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "game/world.hpp"
#include "play/episode_statistics.hpp"
#include "play/mlp.hpp"
#include "play/policy.hpp"

namespace matrixworld {

// One team's candidates: genomes of one network, (n, genome_size) floats, or a script.
struct Candidates {
    std::optional<Network> network;
    const float* genomes = nullptr;
    int n = 1;
    const Script* script = nullptr;
};

struct Match {
    int pursuer;  // which candidate
    int evader;
    std::uint64_t seed;
};

// Called with the world after the reset (without actions) and after every step.
using Watcher = std::function<void(const World& world, const std::vector<std::uint8_t>* actions)>;

// Scores, (n matches, n_worlds), in the order of the matches.
std::vector<EpisodeStatistics> play_matches(const std::shared_ptr<const Setup>& setup,
                                            const Candidates& pursuers, const Candidates& evaders,
                                            const std::vector<Match>& matches, int n_worlds,
                                            int n_threads);

// Plays one episode of a match again, for a watcher.
EpisodeStatistics watch_match(const std::shared_ptr<const Setup>& setup, const Candidates& pursuers,
                              const Candidates& evaders, const Match& match, std::uint64_t episode,
                              const Watcher& watcher);

}  // namespace matrixworld
