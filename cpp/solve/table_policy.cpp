#include "solve/table_policy.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace matrixworld {

void Tables::check(const Config& config) const {
    const Config& own = states->setup().config;
    static_assert(std::has_unique_object_representations_v<Rules>,
                  "bytes tell whether two are equal");
    const bool same_rules = std::memcmp(&own.rules, &config.rules, sizeof(Rules)) == 0;
    const bool same_world = own.rows == config.rows && own.cols == config.cols &&
                            own.n_pursuers == config.n_pursuers &&
                            own.n_evaders == config.n_evaders && own.diagonal == config.diagonal &&
                            own.map.size() == config.map.size() && (own.map == config.map).all() &&
                            config.n_random_obstacles() == 0;
    if (!same_rules || !same_world) {
        throw std::invalid_argument(
            "policy: expected the world that it was solved for, got another");
    }
    if (config.max_steps > steps) {
        throw std::invalid_argument("policy: expected at most the " + std::to_string(steps) +
                                    " steps that it was solved for, got " +
                                    std::to_string(config.max_steps));
    }
}

void TablePolicy::choose(World& world, const Occupancy&) {
    if (world.team(agents_.front()) != tables_->team) {
        throw std::invalid_argument("policy: expected to play for its own team, got the other");
    }
    const States& states = *tables_->states;
    const int turn = turn_of(world);
    const std::int64_t state = states.find(world, turn, order_);
    // Such as an episode with a map of its own.
    if (state < 0 || world.has_own_terrain()) {
        throw std::invalid_argument(
            "policy: expected a moment that can follow a start on distinct free cells of the "
            "solved world, got another");
    }
    int joint = draw_joint(world, turn, state);
    int first = 0;
    int last = 0;
    world.actors(turn, first, last);
    for (int i = last - 1; i >= first; --i) {  // the last agent that acts is the lowest digit
        if (world.team(order_[i]) != tables_->team) continue;
        const auto agent = std::find(agents_.begin(), agents_.end(), order_[i]);
        const int action = joint % world.config().n_actions();
        if (agent != agents_.end()) {
            chosen_[agent - agents_.begin()] = static_cast<std::uint8_t>(action);
        }
        joint /= world.config().n_actions();
    }
}

// The turn in which the first agent that decides acts.
int TablePolicy::turn_of(const World& world) const {
    for (int turn = 0;; ++turn) {
        int first = 0;
        int last = 0;
        world.actors(turn, first, last);
        if (agents_.front() < last) return turn;
    }
}

int TablePolicy::draw_joint(const World& world, int turn, std::int64_t state) const {
    const States& states = *tables_->states;
    const int n_joint = states.n_joint(turn, tables_->team);
    const int left = std::min(world.config().max_steps - world.steps(), tables_->n_rounds);
    const std::int64_t row = (left - 1) * states.n_states(turn) + state;
    const float* const weights = &tables_->by_turn[turn][row * n_joint];
    const int index = kTeams * turn + static_cast<int>(tables_->team);
    const Block block = world.key().block(Purpose::DecideTogether, index, world.steps());
    double rest = static_cast<double>(block[0] >> 11) * 0x1p-53;
    int chosen = 0;
    for (int joint = 0; joint < n_joint; ++joint) {
        if (weights[joint] <= 0) continue;
        chosen = joint;  // the last one also where rounding leaves a rest
        rest -= weights[joint];
        if (rest < 0) break;
    }
    return chosen;
}

void TablePolicy::weigh(const World&, const Occupancy&, double*) {
    throw std::invalid_argument("policy: expected one whose members decide independently");
}

}  // namespace matrixworld
