// Prints one number for matches under every combination of the rules, by networks without memory
// and with it, by ratings and programs, and by all scripts: a hash of the statistics of episodes, of
// what networks compute and of the inputs of moves, bit by bit. It is the same for every compiler, system and instruction set (.ci/bits).
//
//     same_bits [rounds]
#include <cstring>

#include "scenes.hpp"

namespace matrixworld::tests {
namespace {

// FNV-1a of numbers, the lowest byte first.
class Hash {
  public:
    template <typename T>
    void add(T number) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof(number));
        for (std::size_t i = 0; i < sizeof(number); ++i, bits >>= 8) {
            value_ = (value_ ^ (bits & 255)) * 0x100000001B3;
        }
    }
    template <typename T, std::size_t n>
    void add(const std::array<T, n>& numbers) {
        for (const T number : numbers) add(number);
    }
    void add(const EpisodeStatistics& s) {
        add(std::array{s.capture_rate, s.ever_capture_rate, s.captured_fraction});
        add(s.length);
        add(s.returns);
        add(s.survivors);
        add(s.overlap);
        add(s.collisions);
        add(s.faults);
        add(s.agent_steps);
    }

    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xCBF29CE484222325;
};

Hash hash;

// The outputs of a team's network for its agents, whose memories it reads.
void add_outputs(const World& world, const Occupancy& occupancy, const Candidates& candidates,
                 Team team) {
    if (!candidates.network) return;
    std::vector<int> agents;
    for (int a : world.living()) {
        if (world.team(a) == team) agents.push_back(a);
    }
    Mlp mlp(*candidates.network, world.grid());
    mlp.load(candidates.genomes);
    std::vector<std::uint8_t> actions;
    mlp.act(world, occupancy, agents, std::vector<float>(agents.size()), actions);
    const int n_actions = candidates.network->n_actions();
    for (std::size_t i = 0; i < agents.size(); ++i) {
        for (int a = 0; a < n_actions; ++a) hash.add(mlp.logits()[i * padded(n_actions) + a]);
    }
}

void add_game(const Game& game) {
    for (const EpisodeStatistics& episode : game.play(1)) hash.add(episode);
    int n_moments = 0;
    play_episode(
        game.setup, game.pursuers->candidates, game.evaders->candidates, game.matches[0], 0,
        [&](const World& world, const Occupancy& occupancy, const std::vector<std::uint8_t>*) {
            for (const float reward : world.rewards()) hash.add(reward);
            if (n_moments++ % 4 != 2) return;
            const Config& config = world.config();
            std::vector<float> numbers(static_cast<std::size_t>(config.n_agents()) *
                                       config.n_actions() * kInputs);
            MoveInputs(config).write(world, occupancy, numbers.data());
            for (const float number : numbers) hash.add(number);
            add_outputs(world, occupancy, game.pursuers->candidates, Team::Pursuer);
            add_outputs(world, occupancy, game.evaders->candidates, Team::Evader);
        });
}

// Of each kind of network, ratings, and scripts in turn, against any opponent.
void play_row(const Rules& rules, Random& random) {
    static std::size_t n_played = 0;
    using Kind = matrixworld::Memory;
    for (const Kind kind : {Kind::None, Kind::Gru}) {
        Config config = random_config(rules, random);
        config.fov = std::min(config.fov, 15);  // genomes of wide views take most of the time
        auto team = random_networks(config, random.between(1, 2), kind, random);
        auto opponent = random_side(config, random);
        if (random.chance(50)) std::swap(team, opponent);
        add_game({config, std::move(team), std::move(opponent), 1, 3, random});
    }
    Config config = random_config(rules, random);
    auto ratings = random_ratings(config, random);
    add_game({config, std::move(ratings), random_side(config, random), 1, 3, random});
    config.fov = std::max(config.fov, RightOfWay::kLeastFov);
    auto team = std::make_unique<Side>();
    team->candidates.script = &scripts()[n_played++ % scripts().size()];
    add_game({config, std::move(team), random_side(config, random), 1, 3, random});
}

}  // namespace
}  // namespace matrixworld::tests

int main(int argc, char** argv) {
    using namespace matrixworld::tests;
    Random random(49);
    play_all("a row", play_row, argc, argv, random);
    std::printf("%016llx\n", static_cast<unsigned long long>(hash.value()));
    return n_failed;
}
