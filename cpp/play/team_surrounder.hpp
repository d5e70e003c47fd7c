// How the script team-surrounder rates the moves of an agent. It decides from the agent's view, its
// number, the step and random draws alone; agents that see the same come to the same division of
// work without a word.
//
//   hold      beside an adversary it stays, except to break up crowds (see `rate_as_holder`)
//   allocate  the nearest free teammates share the open sides of the adversaries in view
//   approach  it goes to its side by the shortest way
//   search    in few, teams of as many as surround an adversary sweep the grid in lines; in many,
//             each agent mows the grid on its own
//
// Numbers were chosen by trial: 4 directions, 40 x 40 cells, view 11 x 11, adversaries at random.
#pragma once

#include <cstdint>

#include "game/world.hpp"
#include "play/script.hpp"

namespace matrixworld {

// Writes worth[move] for all moves. Precondition: `sight` is the agent's.
void rate_for_team(const World& world, const Sight& sight, int agent, std::uint32_t draw,
                   int* worth);

// The best moves of the plan by which an agent searches, as bits.
std::uint32_t search_moves(const World& world, const Sight& sight, int agent);

}  // namespace matrixworld
