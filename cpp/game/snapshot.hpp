// A world written down between two turns: everything that the turns to come depend on, and what is
// reported of the last one. Pickling, deep copies and worlds read out of a batch go through it.
//
// `for_each_field` is the only list of the fields: the check of a snapshot and its conversion to
// and from a Python dict are loops over it. A new field needs a member and a row here, and a line
// in snapshot.cpp that copies it.
#pragma once

#include <optional>
#include <vector>

#include "game/resolve.hpp"
#include "grid/grid.hpp"
#include "grid/random.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

struct Snapshot {
    EpisodeKey key;
    ByteArray map;            // (rows * cols) 1 where an obstacle is
    IntArray cells;           // by agent: an index into the rows * cols cells; kGone when gone
    IntArray last_cells;      // by agent that is gone: where it disappeared, likewise
    ByteArray captured;       // by evader
    ByteArray ever_captured;  // by evader
    ByteArray capture_paid;   // by evader
    IntArray captors;         // by evader
    FloatArray rewards;       // by agent
    IntArray report;          // by agent: the bits of involved and at_fault
    std::vector<int> participants;  // of the last turn; read where agents act one at a time
    int steps = 0;
    bool first_turn = false;  // no turn of the present round has been played
    bool terminated = false;
    bool truncated = false;
    IntArray memory_steps;  // by agent: see Memories::write
    IntArray memory_sizes;  // by agent
    std::vector<float> memories;
};

// The values that the entries of a field may have, both ends included.
struct Limits {
    int low;
    int high;
};

// One row of the table. `size` is the number of entries; 1 for a plain number.
struct SnapshotField {
    const char* name;
    std::int64_t size;
    std::optional<Limits> limits = {};
};

constexpr std::int64_t kAnySize = -1;
constexpr int kMostMemory = 1 << 20;  // numbers of an agent; the largest layer of a network

// Calls visit(field, value) for every field of a (const) snapshot of a world of this configuration.
template <typename AnySnapshot, typename Visit>
void for_each_field(AnySnapshot& s, const Config& config, Visit visit) {
    const int n_cells = config.rows * config.cols;
    const int n_agents = config.n_agents();
    const int n_evaders = config.n_evaders;
    const Limits flag{0, 1};
    const Limits cell_or_gone{kGone, n_cells - 1};
    using Field = SnapshotField;

    visit(Field{"seed", 1}, s.key.seed);
    visit(Field{"episode", 1}, s.key.episode);
    visit(Field{"map", n_cells, flag}, s.map);
    visit(Field{"cells", n_agents, cell_or_gone}, s.cells);
    visit(Field{"last_cells", n_agents, cell_or_gone}, s.last_cells);
    visit(Field{"captured", n_evaders, flag}, s.captured);
    visit(Field{"ever_captured", n_evaders, flag}, s.ever_captured);
    visit(Field{"capture_paid", n_evaders, flag}, s.capture_paid);
    visit(Field{"captors", n_evaders, Limits{0, config.n_pursuers}}, s.captors);
    visit(Field{"rewards", n_agents}, s.rewards);
    visit(Field{"report", n_agents, Limits{0, kReportMask}}, s.report);
    visit(Field{"participants", kAnySize, Limits{0, n_agents - 1}}, s.participants);
    visit(Field{"steps", 1, Limits{0, config.max_steps}}, s.steps);
    visit(Field{"first_turn", 1, flag}, s.first_turn);
    visit(Field{"terminated", 1, flag}, s.terminated);
    visit(Field{"truncated", 1, flag}, s.truncated);
    visit(Field{"memory_steps", n_agents, Limits{-1, config.max_steps}}, s.memory_steps);
    visit(Field{"memory_sizes", n_agents, Limits{0, kMostMemory}}, s.memory_sizes);
    visit(Field{"memories", kAnySize}, s.memories);
}

}  // namespace matrixworld
