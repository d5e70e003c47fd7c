// How agents search the grid while they see nobody. They decide from their view, their number, the
// step and a draw at the beginning alone.
//
// In few, teams of as many as surround an adversary sweep the grid in lines; in many, each agent mows
// the grid on its own.
#pragma once

#include <cstdint>

#include "game/world.hpp"
#include "observe/near_view.hpp"
#include "observe/sight.hpp"

namespace matrixworld {

// Writes what each move is worth to the search, at least 0. Precondition: the view is the agent's,
// and `worth` is all zeros.
void rate_search(const World& world, const near_view::NearView& view, int agent, int* worth);
// The moves that are worth most among those not into an obstacle, as bits.
std::uint32_t search_moves(const World& world, const Sight& sight, int agent);

}  // namespace matrixworld
