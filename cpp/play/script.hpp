// Scripted opponents, each a row of data: which cells it looks to, what a move is worth with regard
// to them, how often it errs, and how it searches.
//
// A script takes, of the moves that lead into no obstacle, one of those that are worth most, all of
// them equally likely. Where it looks to no cell it walks at random, or on in one direction.
#pragma once

#include <string>
#include <vector>

#include "game/occupancy.hpp"
#include "game/world.hpp"

namespace matrixworld {

// Rows and columns from an agent's own cell.
struct Offset {
    int row;
    int col;
};
using Offsets = std::vector<Offset>;

// What one agent sees of the others.
class Sight {
  public:
    explicit Sight(int fov) : set_(static_cast<std::size_t>(kChannels) * fov * fov) {}

    void look(const World& world, const Occupancy& occupancy, int agent);

    const Offsets& adversaries() const { return adversaries_; }  // cells that hold some
    const Offsets& teammates() const { return teammates_; }
    bool is_free(Offset cell) const;                  // neither obstacle nor border
    int moves(Offset from, Offset to) const;          // from one cell to the other
    int n_neighbors() const { return n_moves_ - 1; }  // cells beside a cell

  private:
    const World* world_ = nullptr;
    Offset own_{0, 0};  // row and column of the agent
    int n_moves_ = 0;
    Offsets adversaries_;
    Offsets teammates_;
    std::vector<int> set_;
};

struct Script {
    using Goals = void (*)(const Sight& sight, Offsets& goals);
    using Worth = int (*)(const Sight& sight, const Offsets& goals, Offset there);

    const char* name;
    Goals goals;  // the cells that it looks to; null: it looks at nothing and stays
    Worth worth;  // of being `there`
    int slips;    // of kSlipSteps steps, those in which it takes any action, all equally likely
    int stride;   // steps that it walks on in one direction without a goal; 0: walks at random
};

constexpr int kSlipSteps = 256;

const std::vector<Script>& scripts();
// The script of this name, null without one.
const Script* find_script(const std::string& name);

}  // namespace matrixworld
