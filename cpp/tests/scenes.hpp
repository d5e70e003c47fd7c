// Building blocks of the drivers: counted checks, a generator, random configurations, policies and
// memory, and the play under every combination of the rules.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/world.hpp"
#include "observe/observe.hpp"
#include "play/buffers.hpp"
#include "play/mlp.hpp"
#include "play/program.hpp"
#include "play/rollout.hpp"

namespace matrixworld::tests {

using SharedSetup = std::shared_ptr<const Setup>;

struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline std::atomic<long> n_passed{0};

inline void require(bool holds, const char* what) {
    if (!holds) throw Failure(what);
    ++n_passed;
}

// Does `action` throw std::invalid_argument?
template <typename Action>
bool refused(Action action) {
    try {
        action();
    } catch (const std::invalid_argument&) {
        return true;
    }
    return false;
}

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t bits() { return engine_(); }
    int below(int n) { return matrixworld::below(bits(), n); }
    int between(int low, int high) { return low + below(high - low + 1); }
    bool chance(int percent) { return below(100) < percent; }
    float weight() { return 4 * unit(bits()) - 2; }

    template <typename T>
    T one_of(std::initializer_list<T> values) {
        return values.begin()[below(static_cast<int>(values.size()))];
    }

  private:
    std::mt19937_64 engine_;
};

// Every combination of the fields of `Rules`.
inline std::vector<Rules> all_rules() {
    const Outcome outcomes[] = {Outcome::Disappear, Outcome::Reach, Outcome::Bounce};
    const Interaction interactions[] = {Interaction::Simultaneous, Interaction::SwarmTurns,
                                        Interaction::AgentTurns};
    std::vector<Rules> rows;
    for (Interaction interaction : interactions)
        for (Outcome obstacle : outcomes)
            for (Outcome teammate : outcomes)
                for (Outcome evader : outcomes)
                    for (Outcome pursuer : outcomes)
                        for (Capture capture : {Capture::Occupation, Capture::Surround})
                            for (bool disappear : {false, true})
                                rows.push_back({interaction, obstacle, teammate, evader, pursuer,
                                                capture, disappear});
    return rows;
}

// The paper's, or values of which a double holds every sum exactly, in whatever order.
inline Rewards random_rewards(Random& random) {
    Rewards rewards;
    rewards.capture_repeats = random.chance(30);
    rewards.blame = random.one_of({Blame::Fault, Blame::Involved});
    if (random.chance(50)) return rewards;
    for (int t = 0; t < kTeams; ++t) {
        rewards.capture[t] = random.weight();
        rewards.neighbor[t] = random.weight();
        rewards.step[t] = random.weight();
        for (float& penalty : rewards.collide[t]) penalty = random.weight();
    }
    return rewards;
}

// Chooses the obstacles of a configuration and returns the number of cells that stay free.
inline int lay_obstacles(Config& config, Random& random) {
    const int area = config.rows * config.cols;
    if (random.chance(30)) {
        config.density = random.below(50) / 100.0;
        return area - config.n_random_obstacles();
    }
    if (random.chance(50)) return area;
    config.map = ByteArray::Zero(area);
    for (int i = 0; i < area; ++i) config.map[i] = random.chance(25);
    return area - config.map.cast<int>().sum();
}

// Mostly small grids, in which agents meet often, and sometimes wide ones; fields of view below and
// above the size of the grid.
inline Config random_config(const Rules& rules, Random& random) {
    Config config;
    config.rules = rules;
    config.rows = random.chance(90) ? random.between(1, 7) : random.between(8, 70);
    config.cols = random.chance(90) ? random.between(2, 7) : random.between(8, 70);
    int free = lay_obstacles(config, random);
    if (free < 2) {
        config.density = 0;
        config.map = {};
        free = config.rows * config.cols;
    }
    // Up to 12, 40 and 200 agents: below and above kMaxPositions, where views take another path.
    const int most = random.one_of({12, 12, 12, 40, 200});
    const int total = random.between(2, std::min(free, most));
    config.n_pursuers = random.between(1, total - 1);
    config.n_evaders = total - config.n_pursuers;
    // 55 and 57 lie on either side of what one read of a bitboard holds.
    config.fov = random.chance(90) ? random.one_of({1, 3, 5, 7, 11, 15, 21})
                                   : random.one_of({55, 57, 61, 113});
    config.diagonal = random.chance(40);
    config.max_steps = random.between(1, 12);
    config.rewards = random_rewards(random);
    return config;
}

inline std::vector<std::uint8_t> random_actions(const Config& config, int n, Random& random) {
    std::vector<std::uint8_t> actions(static_cast<std::size_t>(n));
    for (auto& action : actions)
        action = static_cast<std::uint8_t>(random.below(config.n_actions()));
    return actions;
}

// One team's candidates, with the genomes that they refer to.
struct Side {
    Candidates candidates;
    std::vector<float> genomes;
};

// Random numbers are drawn in statements or in braces, never among the arguments of a function: there
// the compiler chooses the order.
inline std::unique_ptr<Side> random_networks(const Config& config, int n_hidden,
                                             matrixworld::Memory memory, Random& random) {
    auto side = std::make_unique<Side>();
    std::vector<int> hidden(static_cast<std::size_t>(n_hidden));
    for (int& size : hidden) size = random.one_of({1, 7, 16, 20, 32, 33, 64});
    const Activation activation = random.one_of({Activation::Relu, Activation::Tanh});
    const bool sampled = random.chance(70);
    side->candidates.network.emplace(config.fov, hidden, config.n_actions(), activation, sampled,
                                     memory);
    side->candidates.n = random.between(1, 3);
    side->genomes.resize(static_cast<std::size_t>(side->candidates.n) *
                         static_cast<std::size_t>(side->candidates.network->genome_size()));
    for (float& gene : side->genomes) gene = random.weight();
    side->candidates.genomes = side->genomes.data();
    return side;
}

inline std::unique_ptr<Side> random_networks(const Config& config, int n_hidden, Random& random) {
    using Kind = matrixworld::Memory;
    const Kind kind = random.one_of({Kind::None, Kind::Gru});
    return random_networks(config, n_hidden, n_hidden ? kind : Kind::None, random);
}

// A program of a few random instructions, then additions until one number is left.
inline std::vector<float> random_program(const RatingShape& shape, Random& random) {
    std::vector<float> code;
    int depth = 0;
    for (int n = random.between(1, shape.length / 2); n > 0; --n) {
        int operation = random.between(kInput, kOperators - 1);
        if (operations()[operation].n_arguments > depth) operation = kInput + random.below(2);
        float operand = 0;
        if (operation == kConstant) operand = random.weight();
        if (operation == kInput) operand = random.below(static_cast<int>(shape.inputs.size()));
        code.insert(code.end(), {static_cast<float>(operation), operand});
        depth += 1 - operations()[operation].n_arguments;
    }
    for (; depth > 1; --depth) code.insert(code.end(), {static_cast<float>(kAdd), 0.0f});
    code.resize(static_cast<std::size_t>(shape.genome_size()));
    return code;
}

// Policies that rate moves: networks or programs.
inline std::unique_ptr<Side> random_ratings(const Config& config, Random& random) {
    auto side = std::make_unique<Side>();
    RatingShape shape{config.fov, config.n_actions(), {}, {}, 0, MoveMask::None};
    while (shape.inputs.empty()) {
        for (int input = 0; input < kInputs; ++input) {
            if (random.chance(50)) shape.inputs.push_back(input);
        }
    }
    if (random.chance(50)) shape.length = random.between(1, 16) * 2;
    for (int n = shape.length ? 0 : random.below(3); n > 0; --n) {
        shape.hidden.push_back(random.one_of({1, 3, 4, 9}));
    }
    shape.mask = random.one_of({MoveMask::None, MoveMask::Obstacles, MoveMask::RightOfWay});
    side->candidates.n = random.between(1, 3);
    for (int i = 0; i < side->candidates.n; ++i) {
        std::vector<float> genome(static_cast<std::size_t>(shape.genome_size()));
        for (float& gene : genome) gene = random.weight();
        if (shape.length) genome = random_program(shape, random);
        side->genomes.insert(side->genomes.end(), genome.begin(), genome.end());
    }
    shape.check_genomes(side->genomes.data(), static_cast<std::size_t>(side->candidates.n));
    side->candidates.rating = shape;
    side->candidates.genomes = side->genomes.data();
    return side;
}

inline std::unique_ptr<Side> random_side(const Config& config, Random& random) {
    if (random.chance(25)) return random_ratings(config, random);
    if (!random.chance(40)) {
        const int n_hidden = random.below(4);
        return random_networks(config, n_hidden, random);
    }
    auto side = std::make_unique<Side>();
    side->candidates.script =
        &scripts()[static_cast<std::size_t>(random.below(static_cast<int>(scripts().size())))];
    return side;
}

// Matches between two teams.
struct Game {
    Game(const Config& config, std::unique_ptr<Side> first, std::unique_ptr<Side> second,
         int n_matches, int n_worlds, Random& random)
        : setup(std::make_shared<const Setup>(config)),
          pursuers(std::move(first)),
          evaders(std::move(second)),
          matches(static_cast<std::size_t>(n_matches)),
          n_worlds(n_worlds) {
        for (Match& match : matches) {
            match = {random.below(pursuers->candidates.n), random.below(evaders->candidates.n),
                     random.bits()};
        }
    }

    std::vector<EpisodeStatistics> play(int n_threads, bool one_by_one = false) const {
        return play_matches(setup, pursuers->candidates, evaders->candidates, matches, n_worlds,
                            n_threads, {}, one_by_one);
    }

    SharedSetup setup;
    std::unique_ptr<Side> pursuers;
    std::unique_ptr<Side> evaders;
    std::vector<Match> matches;
    int n_worlds;
};

inline Game random_game(const Rules& rules, int n_matches, int n_worlds, Random& random) {
    const Config config = random_config(rules, random);
    return Game{
        config, random_side(config, random), random_side(config, random), n_matches, n_worlds,
        random};
}

// Memory for every output field, and for float views, of exactly the size that is written, so that a
// sanitizer finds a write beyond it.
struct Memory {
    Memory(const Config& config, int n_worlds) {
        for (const OutputFields* fields : {&world_fields(), &batch_fields()}) {
            for (const OutputField& field : *fields) {
                const std::size_t n = field.n_items(config) * static_cast<std::size_t>(n_worlds);
                buffers.add(field, config, block(n * item_size(field.dtype)));
                if (!field.write_floats) continue;
                buffers.add(field, config, block(n * item_size(DType::Float32)), true);
            }
        }
    }

    std::uint8_t* block(std::size_t size) {
        bytes.emplace_back(size, std::uint8_t{0xEE});
        return bytes.back().data();
    }

    std::vector<std::vector<std::uint8_t>> bytes;
    Buffers buffers;
};

inline void check_same(const EpisodeStatistics& a, const EpisodeStatistics& b) {
    require(a.capture_rate == b.capture_rate && a.ever_capture_rate == b.ever_capture_rate &&
                a.captured_fraction == b.captured_fraction,
            "the same captures");
    require(a.length == b.length && a.survivors == b.survivors, "the same length and survivors");
    require(a.returns == b.returns && a.overlap == b.overlap, "the same returns and overlap");
    require(a.collisions == b.collisions && a.faults == b.faults, "the same collisions");
    require(a.agent_steps == b.agent_steps, "the same agent-steps");
}

inline void check_same(const std::vector<EpisodeStatistics>& a,
                       const std::vector<EpisodeStatistics>& b) {
    require(a.size() == b.size(), "statistics of all episodes");
    for (std::size_t i = 0; i < a.size(); ++i) check_same(a[i], b[i]);
}

// ---- Drivers ---------------------------------------------------------------------------------

inline int n_failed = 0;

template <typename Play>
void run(const std::string& name, Play play) {
    try {
        play();
    } catch (const std::exception& error) {
        ++n_failed;
        std::printf("%s: %s\n", name.c_str(), error.what());
    }
}

// Plays under the combinations of the rules: each of them, or one out of `stride`, as many times as
// the driver's argument says. With a stride of 5, five times are all of them.
template <typename Play>
void play_all(const char* name, Play play, int argc, char** argv, Random& random, int stride = 1) {
    const std::vector<Rules> rows = all_rules();
    const int n_rounds = argc > 1 ? std::atoi(argv[1]) : 1;
    for (std::size_t i = 0; i * stride < rows.size() * n_rounds; ++i) {
        const std::size_t row = i * stride % rows.size();
        run("rules " + std::to_string(row) + ", " + name, [&] { play(rows[row], random); });
    }
}

// Prints the number of checks and returns the exit code of a driver.
inline int finish(const char* name) {
    std::printf("%s: %ld checks passed, %d failed\n", name, n_passed.load(), n_failed);
    return n_failed == 0 ? 0 : 1;
}

}  // namespace matrixworld::tests
