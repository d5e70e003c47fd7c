#include "observe/sight.hpp"

#include <algorithm>
#include <cstdlib>

#include "observe/observe.hpp"

namespace matrixworld {

void Sight::look(const World& world, const Occupancy& occupancy, int agent) {
    world_ = &world;
    own_ = {world.grid().row(world.cell(agent)), world.grid().col(world.cell(agent))};
    n_moves_ = world.config().n_actions();
    adversaries_.clear();
    teammates_.clear();
    const int fov = world.config().fov;
    const int own_channel = world.team(agent) == Team::Pursuer ? kPursuers : kEvaders;
    const int n_set = list_agents(world, occupancy, agent, set_.data());
    // The view is flattened as (channel, row, column), with the agent in the middle.
    for (int i = 0; i < n_set; ++i) {
        const int cell = set_[i] % (fov * fov);
        Offsets& seen = set_[i] / (fov * fov) == own_channel ? teammates_ : adversaries_;
        seen.push_back({cell / fov - fov / 2, cell % fov - fov / 2});
    }
}

bool Sight::is_free(Offset cell) const {
    const int number = world_->grid().cell(own_.row + cell.row, own_.col + cell.col);
    return world_->terrain().kind[number] == kFree;
}

bool Sight::is_blocked(Offset cell) const {
    return *world_->terrain().blocked.window(own_.row + cell.row, own_.col + cell.col);
}

int Sight::moves(Offset from, Offset to) const {
    const int rows = std::abs(from.row - to.row);
    const int cols = std::abs(from.col - to.col);
    return world_->config().diagonal ? std::max(rows, cols) : rows + cols;
}

}  // namespace matrixworld
