#include "player.hpp"

#include <algorithm>
#include <climits>
#include <cstdlib>

namespace matrixworld {

namespace {

constexpr int kAgentsPerBlock = 2 * kDrawsPerBlock;  // 32 bits for each

}  // namespace

void Player::decide(const World& world, const Occupancy& occupancy, int first, int last,
                    std::vector<std::uint8_t>& actions) {
    const auto room = static_cast<std::size_t>(last - first);
    agents_.resize(room);
    draws_.resize(room);
    std::size_t n = 0;
    Block block{};
    int number = -1;
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
    if (n == 0) return;
    choose(world, occupancy);
    for (std::size_t i = 0; i < n; ++i) actions[agents_[i]] = chosen_[i];
}

void NetworkPlayer::choose(const World& world, const Occupancy& occupancy) {
    units_.resize(draws_.size());
    for (std::size_t i = 0; i < draws_.size(); ++i) units_[i] = unit(draws_[i]);
    mlp_.act(world, occupancy, agents_, units_, chosen_);
}

void ScriptedPlayer::choose(const World& world, const Occupancy& occupancy) {
    const int n_actions = world.config().n_actions();
    for (std::size_t i = 0; i < agents_.size(); ++i) {
        switch (script_) {
            case Script::Random:
                chosen_[i] = static_cast<std::uint8_t>(below(draws_[i], n_actions));
                break;
            case Script::Still:
                chosen_[i] = 0;
                break;
            case Script::Chaser:
            case Script::Fleer:
                chosen_[i] = chase_or_flee(world, occupancy, agents_[i], draws_[i]);
                break;
        }
    }
}

std::uint8_t ScriptedPlayer::chase_or_flee(const World& world, const Occupancy& occupancy,
                                           int agent, std::uint32_t draw) {
    const Team adversary = world.team(agent) == Team::Pursuer ? Team::Evader : Team::Pursuer;
    const int n_set = list_agents(world, occupancy, agent, view_.data());
    int best = 0;
    int n_best = 0;
    std::uint8_t moves[kDiagonalMoves];
    for (int move = 0; move < world.config().n_actions(); ++move) {
        const int there = world.cell(agent) + world.grid().delta(move);
        if (move != 0 && world.ground().kind[there] != kFree) continue;
        const int distance = distance_after(world, adversary, n_set, move);
        const int value = script_ == Script::Chaser ? -distance : distance;
        if (n_best == 0 || value > best) {
            best = value;
            n_best = 0;
        }
        if (value == best) moves[n_best++] = static_cast<std::uint8_t>(move);
    }
    return moves[below(draw, n_best)];
}

// Moves from the cell that `move` leads to, to the nearest adversary in view; INT_MAX without one.
int ScriptedPlayer::distance_after(const World& world, Team adversary, int n_set, int move) const {
    const int fov = world.config().fov;
    const int channel = adversary == Team::Pursuer ? kPursuers : kEvaders;
    int nearest = INT_MAX;
    for (int i = 0; i < n_set; ++i) {
        if (view_[i] / (fov * fov) != channel) continue;
        const int place = view_[i] % (fov * fov);
        const int rows = std::abs(place / fov - fov / 2 - kRowStep[move]);
        const int cols = std::abs(place % fov - fov / 2 - kColStep[move]);
        nearest = std::min(nearest, world.config().diagonal ? std::max(rows, cols) : rows + cols);
    }
    return nearest;
}

}  // namespace matrixworld
