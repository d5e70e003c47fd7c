#include "play/script.hpp"

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <stdexcept>

#include "observe/inputs.hpp"
#include "observe/observe.hpp"
#include "observe/right_of_way.hpp"
#include "play/team_surrounder.hpp"

namespace matrixworld {

namespace {

constexpr Offset kHere{0, 0};

// ---- Goals -----------------------------------------------------------------------------------

void adversaries(const Sight& sight, Offsets& goals) { goals = sight.adversaries(); }

// Adversaries to which no teammate in view is nearer, so that hunters spread over several. If a
// teammate is nearer to each of them, all adversaries.
void unclaimed_adversaries(const Sight& sight, Offsets& goals) {
    for (const Offset& adversary : sight.adversaries()) {
        const int own = sight.moves(kHere, adversary);
        const auto is_nearer = [&](const Offset& teammate) {
            return sight.moves(teammate, adversary) < own;
        };
        const Offsets& team = sight.teammates();
        if (std::none_of(team.begin(), team.end(), is_nearer)) goals.push_back(adversary);
    }
    if (goals.empty()) goals = sight.adversaries();
}

// Free cells beside adversaries, without those on which a teammate stands: the cells that are still
// to be occupied to surround an adversary.
void open_sides(const Sight& sight, Offsets& goals) {
    for (const Offset& adversary : sight.adversaries()) {
        for (int side = 1; side <= sight.n_neighbors(); ++side) {
            const Offset beside{adversary.row + kRowStep[side], adversary.col + kColStep[side]};
            const auto is_there = [&](const Offset& teammate) {
                return teammate.row == beside.row && teammate.col == beside.col;
            };
            const Offsets& team = sight.teammates();
            if (std::any_of(team.begin(), team.end(), is_there)) continue;
            if (sight.is_free(beside)) goals.push_back(beside);
        }
    }
}

// ---- Worth -----------------------------------------------------------------------------------

int nearest(const Sight& sight, const Offsets& goals, Offset there) {
    int moves = INT_MAX;
    for (const Offset& goal : goals) moves = std::min(moves, sight.moves(there, goal));
    return moves;
}

int near(const Sight& sight, const Offsets& goals, Offset there) {
    return -nearest(sight, goals, there);
}

int far(const Sight& sight, const Offsets& goals, Offset there) {
    return nearest(sight, goals, there);
}

// The goals repel like equal charges: the push falls with the square of the distance. Whole numbers,
// so that equal worths are exactly equal; kCharge leaves room for sums over many goals.
int far_from_all(const Sight& sight, const Offsets& goals, Offset there) {
    constexpr int kCharge = 1 << 14;
    int push = 0;
    for (const Offset& goal : goals) {
        const int apart = 1 + sight.moves(there, goal);  // never 0
        push += kCharge / (apart * apart);
    }
    return -push;
}

constexpr int kNever = 0;
constexpr int kHalf = kSlipSteps / 2;

std::vector<Script> with_careful_ones(std::vector<Script> all) {
    const std::vector<Script> plain = all;
    for (Script script : plain) {
        if (!script.goals && !script.rate && script.slips == kNever) continue;  // it never moves
        script.name = "careful-" + script.name;
        script.careful = true;
        all.push_back(script);
    }
    return all;
}

}  // namespace

const std::vector<Script>& scripts() {
    static const std::vector<Script> all = with_careful_ones({
        {"random", nullptr, nullptr, kSlipSteps, 0},
        {"still", nullptr, nullptr, kNever, 0},
        {"chaser", adversaries, near, kNever, 0},
        {"fleer", adversaries, far, kNever, 0},
        {"clumsy-chaser", adversaries, near, kHalf, 0},
        {"hunter", unclaimed_adversaries, near, kNever, kStride},
        {"surrounder", open_sides, near, kNever, kStride},
        {"clumsy-fleer", adversaries, far, kHalf, 0},
        {"dodger", adversaries, far_from_all, kNever, 0},
        {"team-surrounder", nullptr, nullptr, kNever, 0, rate_for_team},
    });
    return all;
}

const Script* find_script(const std::string& name) {
    for (const Script& script : scripts()) {
        if (name == script.name) return &script;
    }
    return nullptr;
}

void require_sight(const std::string& player, const Script& script, const Config& config) {
    if (!script.careful || config.fov >= RightOfWay::kLeastFov) return;
    throw std::invalid_argument(player + ": expected a fov of at least " +
                                std::to_string(RightOfWay::kLeastFov) + " for " + script.name +
                                ", got " + std::to_string(config.fov));
}

}  // namespace matrixworld
