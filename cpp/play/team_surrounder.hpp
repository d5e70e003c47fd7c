// How the script team-surrounder rates the moves of an agent. It decides from the agent's view, its
// number, the step and random draws alone; agents that see the same come to the same division of
// work without a word.
//
//   hold      beside an adversary it stays, except to break up crowds (see `rate_as_holder`)
//   allocate  the nearest free teammates share the open sides of the adversaries in view
//   approach  it goes to its side by the shortest way
//   search    else it searches the grid (observe/search.hpp)
//
// Numbers were chosen by trial: 4 directions, 40 x 40 cells, view 11 x 11, adversaries at random.
#pragma once

#include <cstdint>

#include "game/world.hpp"
#include "observe/sight.hpp"

namespace matrixworld {

// Writes worth[move] for all moves. Precondition: `sight` is the agent's.
void rate_for_team(const World& world, const Sight& sight, int agent, std::uint32_t draw,
                   int* worth);

}  // namespace matrixworld
