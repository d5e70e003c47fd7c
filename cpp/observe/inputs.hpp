// The named inputs of an agent's moves: a few numbers that say what the cell of each move is like. They
// are what policies read that rate moves (play/rating.hpp), and an output of worlds. An agent computes
// them from its own view; must_yield and ahead also depend on the step. Both teams have the same.
//
//     MoveInputs inputs(config);                       // one for each thread
//     inputs.gather(world, scratch.occupancy);     // before the agents of a turn look
//     MoveRows rows{};
//     inputs.look(agent, rows);
//     rows.of[kRoom][move];
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"
#include "grid/compiler.hpp"
#include "kernels/move_look.hpp"
#include "observe/right_of_way.hpp"
#include "observe/search.hpp"
#include "observe/sight.hpp"

namespace matrixworld {

// What users read of an input. Each is at least 0.
struct InputText {
    const char* name;
    const char* definition;
    const char* unit;
    float most;  // 0: there is no bound
};
const InputText (&input_texts())[kInputs];

// Agents without a goal walk in one direction for so many steps, which crosses a usual field of view.
constexpr int kStride = 12;
// The direction of the present stride. It is drawn from the number of the stride, so that no policy
// has to remember anything between steps.
int stride_of(const World& world, int agent, int steps = kStride);

class MoveInputs {
  public:
    explicit MoveInputs(const Config& config);

    // Only these are computed from now on, as bits by Input. At first it is all of them.
    void want(std::uint32_t inputs);
    // Looks at a moment. The world and the occupancy, which it has entered, must stay in memory.
    void gather(const World& world, const Occupancy& occupancy);
    // Computes the wanted inputs of a living agent.
    void look(int agent, MoveRows& rows);

    // Writes the inputs of all agents, (A, moves, kInputs). Those of gone agents are zeros.
    void write(const World& world, const Occupancy& occupancy, float* out);

  private:
    bool wants(Input input) const { return look_.wanted >> input & 1; }
    void survey(const Terrain& terrain);
    void draw_strides();
    void list_reserved(int at, Team own);

    const Config& config_;
    int n_moves_;
    int half_;  // cells from the agent to the end of its view
    // As in MoveLook.
    std::vector<SeenCell> view_;
    std::vector<Apart> apart_;
    std::vector<std::uint64_t> taken_;
    Step steps_[kDiagonalMoves];
    float shares_[kDiagonalMoves + 1];
    MoveLook look_{};
    // Moves that an agent in view forbids, as bits: by team, order of right of way, whether it is an
    // adversary, and near cell.
    std::uint16_t forbids_[kTeams][RightOfWay::kOrders][2][kNearCells + 1] = {};

    const World* world_ = nullptr;
    const Occupancy* occupancy_ = nullptr;
    Sight sight_;
    int order_ = 0;
    std::vector<std::uint8_t> strides_;  // by agent
    EpisodeKey stride_key_;
    int stride_ = -1;  // number of the stride

    // Of the terrain, by cell: the moves that lead to no obstacle, as bits, and the room, in cells.
    std::shared_ptr<const Terrain> terrain_;
    std::vector<std::uint16_t> open_;
    std::vector<std::uint8_t> room_;
    std::vector<std::uint8_t> closed_;  // while a terrain is surveyed
    float exits_[1 << kDiagonalMoves];  // by open moves

    std::vector<const SeenCell*> seen_[2];  // teammates, adversaries, among very many agents
};

}  // namespace matrixworld
