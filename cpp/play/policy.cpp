#include "play/policy.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "observe/inputs.hpp"
#include "play/rating.hpp"

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

void NetworkPolicy::choose(World& world, const Occupancy& occupancy) {
    units_.resize(draws_.size());
    for (std::size_t i = 0; i < draws_.size(); ++i) units_[i] = unit(draws_[i]);
    mlp_.act(world, occupancy, agents_, units_, chosen_);
    const int size = mlp_.network().state_size();
    for (std::size_t i = 0; i < agents_.size() && size > 0; ++i) {
        world.memories().keep(agents_[i], world.steps(), size, mlp_.states()[i]);
    }
}

void NetworkPolicy::weigh(const World& world, const Occupancy& occupancy, double* out) {
    if (mlp_.network().memory != Memory::None) {
        throw std::invalid_argument(
            "network: expected one without memory, whose choices depend on the present state "
            "alone, "
            "got one with memory");
    }
    units_.assign(agents_.size(), 0.0f);
    mlp_.act(world, occupancy, agents_, units_, chosen_);
    const int n_actions = world.config().n_actions();
    const int width = padded(n_actions);
    for (std::size_t i = 0; i < agents_.size(); ++i, out += n_actions) {
        std::fill_n(out, n_actions, 0.0);
        if (!mlp_.network().sampled) {
            out[chosen_[i]] = 1;
            continue;
        }
        const float* const logits = mlp_.logits() + i * width;
        const double largest = *std::max_element(logits, logits + n_actions);
        double total = 0;
        for (int a = 0; a < n_actions; ++a) total += out[a] = std::exp(logits[a] - largest);
        for (int a = 0; a < n_actions; ++a) out[a] /= total;
    }
}

ScriptedPolicy::ScriptedPolicy(const Script& script, const Config& config)
    : script_(script), sight_(config.fov) {
    if (!script.careful) return;
    for (const Team team : {Team::Pursuer, Team::Evader}) ways_.emplace_back(config, team);
}

void ScriptedPolicy::choose(World& world, const Occupancy& occupancy) {
    for (std::size_t i = 0; i < agents_.size(); ++i) {
        // One draw serves two independent decisions: `kSlipSteps` is a power of two, so the lowest
        // bits decide whether the agent slips, and `below` uses the highest for the move.
        const bool slips = static_cast<int>(draws_[i] % kSlipSteps) < script_.slips;
        int moves[kDiagonalMoves];
        chosen_[i] = static_cast<std::uint8_t>(
            slips ? moves[below(draws_[i], list_slips(world, occupancy, agents_[i], moves))]
                  : best_move(world, occupancy, agents_[i], draws_[i]));
    }
}

void ScriptedPolicy::look(const World& world, const Occupancy& occupancy, int agent) {
    sight_.look(world, occupancy, agent);
    goals_.clear();
    if (script_.goals) script_.goals(sight_, goals_);
}

// Does the script consider a move? A careful one asks who has the right of way, the others avoid
// obstacles alone.
bool ScriptedPolicy::allows(const World& world, const Occupancy& occupancy, int agent,
                            int move) const {
    if (script_.careful) {
        const int team = static_cast<int>(world.team(agent));
        return ways_[team].allows(world, occupancy, agent, move);
    }
    return move == 0 || sight_.is_free({kRowStep[move], kColStep[move]});
}

// Lists the moves that the script makes when it errs, and returns how many there are.
int ScriptedPolicy::list_slips(const World& world, const Occupancy& occupancy, int agent,
                               int* moves) const {
    int n = 0;
    for (int move = 0; move < world.config().n_actions(); ++move) {
        if (!script_.careful || allows(world, occupancy, agent, move)) moves[n++] = move;
    }
    return n;
}

int ScriptedPolicy::best_move(const World& world, const Occupancy& occupancy, int agent,
                              std::uint32_t draw) {
    if (!script_.goals && !script_.rate) return 0;
    look(world, occupancy, agent);
    if (script_.rate) {
        script_.rate(world, sight_, agent, draw, rates_);
    } else if (walks()) {
        const int move = stride_of(world, agent, script_.stride);
        if (allows(world, occupancy, agent, move)) return move;
    }
    int moves[kDiagonalMoves];
    const int n_best = find_best(world, occupancy, agent, moves);
    return moves[below(draw, n_best)];
}

// Lists the moves of the highest worth, and returns how many there are.
int ScriptedPolicy::find_best(const World& world, const Occupancy& occupancy, int agent,
                              int* moves) const {
    int best = 0;
    int n_best = 0;
    for (int move = 0; move < world.config().n_actions(); ++move) {
        if (!allows(world, occupancy, agent, move)) continue;
        const int worth = script_.rate
                              ? rates_[move]
                              : script_.worth(sight_, goals_, {kRowStep[move], kColStep[move]});
        if (n_best == 0 || worth > best) {  // the first move, or one better than all before it
            best = worth;
            n_best = 0;
        }
        if (worth == best) moves[n_best++] = move;
    }
    return n_best;
}

void ScriptedPolicy::weigh(const World& world, const Occupancy& occupancy, double* out) {
    const int n_actions = world.config().n_actions();
    const double slips = static_cast<double>(script_.slips) / kSlipSteps;
    if (script_.rate) {
        throw std::invalid_argument(script_.name +
                                    ": expected a script that decides by what it sees and by the "
                                    "step, got one that searches on ways drawn for each episode");
    }
    for (int agent : agents_) {
        std::fill_n(out, n_actions, 0.0);
        int moves[kDiagonalMoves] = {0};
        const int n_slips = list_slips(world, occupancy, agent, moves);
        for (int i = 0; i < n_slips; ++i) out[moves[i]] = slips / n_slips;
        int n_best = 1;
        moves[0] = 0;
        if (script_.goals) {
            look(world, occupancy, agent);
            if (walks()) {
                throw std::invalid_argument(script_.name +
                                            ": expected a script that sees what it looks for in "
                                            "every state, got one that walks on in some");
            }
            n_best = find_best(world, occupancy, agent, moves);
        }
        for (int i = 0; i < n_best; ++i) out[moves[i]] += (1 - slips) / n_best;
        out += n_actions;
    }
}

LoadedPolicy::LoadedPolicy(const Candidates& candidates, const Setup& setup)
    : candidates_(&candidates) {
    if (candidates.network) {
        policy_ = std::make_unique<NetworkPolicy>(*candidates.network, setup.grid);
        genome_size_ = candidates.network->genome_size();
    } else if (candidates.rating) {
        policy_ = std::make_unique<RatingPolicy>(*candidates.rating, setup.config);
        genome_size_ = candidates.rating->genome_size();
    } else if (candidates.make) {
        policy_ = candidates.make();
    } else {
        policy_ = std::make_unique<ScriptedPolicy>(*candidates.script, setup.config);
    }
}

Policy& LoadedPolicy::load(int candidate) {
    if (candidates_->genomes && candidate != loaded_) {
        policy_->load(candidates_->genomes + candidate * genome_size_);
        loaded_ = candidate;
    }
    return *policy_;
}

}  // namespace matrixworld
