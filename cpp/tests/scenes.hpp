// Building blocks of the random tests: counted checks, a generator, random configurations and
// policies.
#pragma once

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "game/world.hpp"
#include "observe/observe.hpp"
#include "play/mlp.hpp"
#include "play/rollout.hpp"

namespace matrixworld::tests {

struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline long n_passed = 0;

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
    config.rewards.capture_repeats = random.chance(30);
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

inline std::unique_ptr<Side> random_side(const Config& config, Random& random) {
    auto side = std::make_unique<Side>();
    if (random.chance(40)) {
        side->candidates.script =
            &scripts()[static_cast<std::size_t>(random.below(static_cast<int>(scripts().size())))];
        return side;
    }
    std::vector<int> hidden(static_cast<std::size_t>(random.below(4)));
    for (int& size : hidden) size = random.one_of({1, 7, 16, 20, 32, 33, 64});
    const Activation activation = random.one_of({Activation::Relu, Activation::Tanh});
    side->candidates.network.emplace(config.fov, hidden, config.n_actions(), activation,
                                     random.chance(70));
    side->candidates.n = random.between(1, 3);
    side->genomes.resize(static_cast<std::size_t>(side->candidates.n) *
                         static_cast<std::size_t>(side->candidates.network->genome_size()));
    for (float& gene : side->genomes) gene = random.weight();
    side->candidates.genomes = side->genomes.data();
    return side;
}

}  // namespace matrixworld::tests
