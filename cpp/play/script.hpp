// Scripted opponents. Each is a row of data: its goals (cells in view), what a move is worth with
// regard to the goals, how often the script errs, and how it searches when it sees no goal.
//
// A script considers the moves that do not lead into an obstacle, and takes one of those with the
// highest worth, all equally likely. Without a goal it walks at random, or straight on for a stride.
// For example
//
//     {"chaser", adversaries, near, kNever, 0}
//
// looks for adversaries, prefers cells near them, never errs, and walks at random if it sees none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"
#include "observe/sight.hpp"

namespace matrixworld {

struct Script {
    using Goals = void (*)(const Sight& sight, Offsets& goals);
    using Worth = int (*)(const Sight& sight, const Offsets& goals, Offset there);
    using Rate = void (*)(const World& world, const Sight& sight, int agent, std::uint32_t draw,
                          int* worth);

    std::string name;
    Goals goals;  // lists its goals; null: the script stays where it is
    Worth worth;  // what it is worth to be `there`
    int slips;    // in this many of kSlipSteps steps it takes any action, all equally likely
    int stride;   // steps in one direction while it has no goal; 0: a direction for each step
    Rate rate = nullptr;   // instead of goals and worth: writes what each move is worth
    bool careful = false;  // takes only moves that right of way allows
};

constexpr int kSlipSteps = 256;  // a power of two: see ScriptedPolicy::choose

// All scripts, then each but "still" once more, with "careful-" before its name.
const std::vector<Script>& scripts();
// The script of this name, or null.
const Script* find_script(const std::string& name);
// Throws std::invalid_argument if agents do not see enough for a careful script.
void require_sight(const std::string& player, const Script& script, const Config& config);

}  // namespace matrixworld
