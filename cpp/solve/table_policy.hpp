// A team that plays joint actions with probabilities from a table: one row for each turn, number of
// rounds left and state. All members act on one draw, so that they can mix together.
#pragma once

#include <memory>
#include <vector>

#include "play/policy.hpp"
#include "solve/states.hpp"

namespace matrixworld {

struct Tables {
    std::shared_ptr<const States> states;
    Team team;
    // The rounds left that have rows of their own: 1 to n_rounds. Where more are left, the last row
    // counts; `steps` says how many there may be.
    int n_rounds;
    int steps;
    std::vector<std::vector<float>> by_turn;  // each (n_rounds, n_states, joint actions)

    // Throws std::invalid_argument unless a world has these states and is short enough.
    void check(const Config& config) const;
};

class TablePolicy : public Policy {
  public:
    explicit TablePolicy(std::shared_ptr<const Tables> tables) : tables_(std::move(tables)) {}

  private:
    void choose(World& world, const Occupancy& occupancy) override;
    void weigh(const World& world, const Occupancy& occupancy, double* out) override;
    int turn_of(const World& world) const;
    int draw_joint(const World& world, int turn, std::int64_t state) const;

    std::shared_ptr<const Tables> tables_;
    std::vector<int> order_;
};

}  // namespace matrixworld
