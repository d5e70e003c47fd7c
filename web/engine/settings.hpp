// Settings, starts and policies from the named arrays that web/src/engine/config.ts writes.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/world.hpp"
#include "named_arrays.hpp"
#include "play/policy.hpp"

namespace matrixworld {

// One number for each team; for the penalties, one for each team and kind.
template <std::size_t kSize>
void copy_all(const Inputs& in, const char* name, float (&out)[kSize]) {
    const std::vector<float> given = in.list<float>(name);
    if (given.size() != kSize) {
        throw std::invalid_argument(std::string(name) + ": expected " + std::to_string(kSize) +
                                    " numbers, got " + std::to_string(given.size()));
    }
    std::copy(given.begin(), given.end(), out);
}

// The numbers of enumerations are the engine's own: tables.ts is made from the compiled extension.
inline Rules to_rules(const Inputs& in) {
    Rules rules;
    rules.interaction = static_cast<Interaction>(in.number<int>("rules.interaction"));
    rules.obstacle = static_cast<Outcome>(in.number<int>("rules.obstacle"));
    rules.teammate = static_cast<Outcome>(in.number<int>("rules.teammate"));
    rules.evader = static_cast<Outcome>(in.number<int>("rules.evader"));
    rules.pursuer = static_cast<Outcome>(in.number<int>("rules.pursuer"));
    rules.capture = static_cast<Capture>(in.number<int>("rules.capture"));
    rules.captured_disappear = in.number<bool>("rules.captured_disappear");
    return rules;
}

inline Rewards to_rewards(const Inputs& in) {
    Rewards rewards;
    copy_all(in, "rewards.capture", rewards.capture);
    copy_all(in, "rewards.neighbor", rewards.neighbor);
    copy_all(in, "rewards.pursuer_collide", rewards.collide[static_cast<int>(Team::Pursuer)]);
    copy_all(in, "rewards.evader_collide", rewards.collide[static_cast<int>(Team::Evader)]);
    copy_all(in, "rewards.step", rewards.step);
    rewards.blame = static_cast<Blame>(in.number<int>("rewards.blame"));
    rewards.capture_repeats = in.number<bool>("rewards.capture_repeats");
    return rewards;
}

inline ByteArray to_bytes(const std::vector<std::uint8_t>& given) {
    return Eigen::Map<const ByteArray>(given.data(), static_cast<Eigen::Index>(given.size()));
}

inline std::shared_ptr<const Setup> to_setup(const Inputs& in) {
    Config config;
    config.rules = to_rules(in);
    config.rewards = to_rewards(in);
    config.rows = in.number<int>("rows");
    config.cols = in.number<int>("cols");
    config.n_pursuers = in.number<int>("n_pursuers");
    config.n_evaders = in.number<int>("n_evaders");
    config.fov = in.number<int>("fov");
    config.diagonal = in.number<bool>("diagonal");
    config.max_steps = in.number<int>("max_steps");
    config.density = in.number<double>("density");
    config.map = to_bytes(in.list<std::uint8_t>("map"));
    return std::make_shared<const Setup>(std::move(config));
}

inline Placement to_placement(const Inputs& in) {
    return {in.list<int>("pursuers"), in.list<int>("evaders"),
            to_bytes(in.list<std::uint8_t>("map"))};
}

inline EpisodeKey to_key(const Inputs& in) {
    return {in.number<std::uint64_t>("seed"), in.number<std::uint64_t>("episode")};
}

// What plays for a team, with the memory of its genome, or of the genomes of a population.
struct Player {
    enum class Genomes { One, Several };

    Player(const Inputs& in, const Config& config, Genomes count = Genomes::One) {
        if (in.has("script")) {
            candidates.script = find_script(in.text("script"));
            if (!candidates.script) {
                throw std::invalid_argument("script: expected the name of a script, got '" +
                                            in.text("script") + "'");
            }
            require_sight("script", *candidates.script, config);
            return;
        }
        genome = in.list<float>("genome");
        std::size_t size = 0;
        if (in.has("inputs")) {  // it rates moves
            candidates.rating = {config.fov,
                                 config.n_actions(),
                                 in.list<int>("inputs"),
                                 in.list<int>("hidden"),
                                 in.number<int>("length"),
                                 to_mask(in.text("mask"))};
            candidates.rating->validate();
            candidates.rating->check_fits("policy", config);
            size = static_cast<std::size_t>(candidates.rating->genome_size());
        } else {
            const auto activation =
                in.text("activation") == "tanh" ? Activation::Tanh : Activation::Relu;
            candidates.network.emplace(config.fov, in.list<int>("hidden"), config.n_actions(),
                                       activation, in.number<bool>("sampled"),
                                       to_memory(in.text("memory")));
            size = static_cast<std::size_t>(candidates.network->genome_size());
        }
        const bool several = count == Genomes::Several && !genome.empty();
        if (several ? genome.size() % size != 0 : genome.size() != size) {
            throw std::invalid_argument("genome: expected " + std::to_string(size) +
                                        " numbers, got " + std::to_string(genome.size()));
        }
        const auto finite = [](float gene) { return std::isfinite(gene); };
        if (!std::all_of(genome.begin(), genome.end(), finite)) {
            throw std::invalid_argument("genome: expected finite numbers, got others");
        }
        candidates.genomes = genome.data();
        candidates.n = static_cast<int>(genome.size() / size);
        if (candidates.rating)
            candidates.rating->check_genomes(genome.data(), genome.size() / size);
    }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    std::vector<float> genome;
    Candidates candidates;
};

// Matches of n_pursuers against n_evaders candidates: three lists of the same length.
inline std::vector<Match> to_matches(const Inputs& in, int n_pursuers, int n_evaders) {
    const auto pursuers = in.list<int>("pursuer"), evaders = in.list<int>("evader");
    const auto seeds = in.list<std::uint64_t>("seed");
    const auto inside = [](const std::vector<int>& given, int n) {
        return std::all_of(given.begin(), given.end(), [n](int i) { return 0 <= i && i < n; });
    };
    if (pursuers.size() != seeds.size() || evaders.size() != seeds.size() ||
        !inside(pursuers, n_pursuers) || !inside(evaders, n_evaders)) {
        throw std::invalid_argument("matches: expected candidates and a seed for each, got others");
    }
    std::vector<Match> matches;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        matches.push_back({pursuers[i], evaders[i], seeds[i]});
    }
    return matches;
}

}  // namespace matrixworld
