#include "play/policy.hpp"

namespace matrixworld {

// Lists the living agents and their draws.
void Policy::draw(const World& world, int first, int last) {
    const auto room = static_cast<std::size_t>(last - first);
    agents_.resize(room);
    draws_.resize(room);
    std::size_t n = 0;
    Block block{};
    int number = -1;
    // An agent's draw depends on its own number and on the step alone. So an episode stays the same
    // whichever other agents are alive, and however the agents are divided into turns.
    for (int a = first; a < last; ++a) {
        if (!world.alive(a)) continue;
        if (a / kAgentsPerBlock != number) {
            number = a / kAgentsPerBlock;
            block = world.key().block(Purpose::Decide, number, world.steps());
        }
        agents_[n] = a;
        const std::uint64_t pair = block[a % kAgentsPerBlock / 2];
        draws_[n] = static_cast<std::uint32_t>(a % 2 ? pair >> 32 : pair);
        ++n;
    }
    agents_.resize(n);
    draws_.resize(n);
    chosen_.resize(n);
}

void draw_units(const World& world, float* units) {
    const int n_blocks = (world.config().n_agents() + kAgentsPerBlock - 1) / kAgentsPerBlock;
    for (int number = 0; number < n_blocks; ++number) {
        const Block block = world.key().block(Purpose::Decide, number, world.steps());
        for (const std::uint64_t pair : block) {
            *units++ = unit(static_cast<std::uint32_t>(pair));
            *units++ = unit(static_cast<std::uint32_t>(pair >> 32));
        }
    }
}

void NetworkPolicy::choose(const World& world, const Occupancy& occupancy) {
    units_.resize(draws_.size());
    for (std::size_t i = 0; i < draws_.size(); ++i) units_[i] = unit(draws_[i]);
    mlp_.act(world, occupancy, agents_, units_, chosen_);
}

void ScriptedPolicy::choose(const World& world, const Occupancy& occupancy) {
    for (std::size_t i = 0; i < agents_.size(); ++i) {
        // One draw serves two independent decisions: `kSlipSteps` is a power of two, so the lowest
        // bits decide whether the agent slips, and `below` uses the highest for the move.
        const bool slips = static_cast<int>(draws_[i] % kSlipSteps) < script_.slips;
        chosen_[i] =
            static_cast<std::uint8_t>(slips ? below(draws_[i], world.config().n_actions())
                                            : best_move(world, occupancy, agents_[i], draws_[i]));
    }
}

int ScriptedPolicy::best_move(const World& world, const Occupancy& occupancy, int agent,
                              std::uint32_t draw) {
    if (!script_.goals) return 0;
    sight_.look(world, occupancy, agent);
    goals_.clear();
    script_.goals(sight_, goals_);
    if (goals_.empty() && script_.stride > 0) {
        const int move = walk_on(world, agent);
        if (sight_.is_free({kRowStep[move], kColStep[move]})) return move;
    }
    int best = 0;
    int n_best = 0;
    int moves[kDiagonalMoves];
    for (int move = 0; move < world.config().n_actions(); ++move) {
        const Offset there{kRowStep[move], kColStep[move]};
        if (move != 0 && !sight_.is_free(there)) continue;
        const int worth = script_.worth(sight_, goals_, there);
        if (n_best == 0 || worth > best) {  // the first move, or one better than all before it
            best = worth;
            n_best = 0;
        }
        if (worth == best) moves[n_best++] = move;
    }
    return moves[below(draw, n_best)];
}

// The direction of the present stride. It is drawn from the number of the stride, so that no policy
// has to remember anything between steps.
int ScriptedPolicy::walk_on(const World& world, int agent) const {
    const int stride = world.steps() / script_.stride;
    const Block block = world.key().block(Purpose::Walk, agent, stride);
    return 1 + below(block[0], world.config().n_actions() - 1);
}

LoadedPolicy::LoadedPolicy(const Candidates& candidates, const Setup& setup)
    : candidates_(&candidates) {
    if (candidates.network) {
        auto policy = std::make_unique<NetworkPolicy>(*candidates.network, setup.grid);
        network_ = policy.get();
        policy_ = std::move(policy);
    } else {
        policy_ = std::make_unique<ScriptedPolicy>(*candidates.script, setup.config.fov);
    }
}

Policy& LoadedPolicy::load(int candidate) {
    if (network_ && candidate != loaded_) {
        network_->load(candidates_->genomes + candidate * candidates_->network->genome_size());
        loaded_ = candidate;
    }
    return *policy_;
}

}  // namespace matrixworld
