// The table of output fields. Every array that worlds and batches write is one row: name, dtype,
// axes, when it is written, and the function that writes it. The bindings check arrays against the
// table, and Python's `array_specs` and `episode_specs` are made from it, so a new output is a new
// row in output_fields.cpp, for example
//
//     field<write_alive>("alive", {Axis::Agents}, Written::Moment)
//
// and a line in the docstring of `array_specs`. No other C++ file lists the fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "game/world.hpp"
#include "observe/inputs.hpp"
#include "observe/observe.hpp"
#include "play/episode_statistics.hpp"

namespace matrixworld {

enum class DType : std::uint8_t { Bool, UInt8, Int32, Int64, UInt64, Float32, Float64 };
std::size_t item_size(DType dtype);

// The axes of one world's part of an array. The array itself has the axis of worlds in front.
enum class Axis : std::uint8_t {
    Agents,
    Evaders,
    Teams,     // pursuers, evaders
    Kinds,     // of collision: with an obstacle, a teammate, an adversary
    RowCol,    // the two coordinates of a cell
    Channels,  // of a view: evaders, pursuers, obstacles
    Fov,       // rows, or columns, of a view
    Rows,
    Cols,
    Moves,
    Inputs,  // of a move, by name
};
using Axes = std::vector<Axis>;
constexpr int kAxes = static_cast<int>(Axis::Inputs) + 1;
const char* name_of(Axis axis);
int size_of(Axis axis, const Config& config);

enum class Written : std::uint8_t {
    Moment,      // after a step or a reset; after an automatic reset, of the new episode
    Step,        // after a step or a reset; after an automatic reset, still of the ended episode
    StepStart,   // before a step, or at a reset
    EpisodeEnd,  // at the end of an episode; stays until the next episode of that world ends
};
constexpr int kTimesWritten = static_cast<int>(Written::EpisodeEnd) + 1;

// What writers read: a world in the memory of the thread that plays it. One object serves a thread
// for all of its worlds, so that writers allocate nothing.
class OutputSource {
  public:
    // Reads this world from now on. To be called again after every change of the world.
    void look_at(const World& world, const Occupancy& occupancy) {
        world_ = &world;
        occupancy_ = &occupancy;
        n_agents_ = static_cast<std::size_t>(world.config().n_agents());
    }

    const World& world() const { return *world_; }
    std::size_t n_agents() const { return n_agents_; }
    const Occupancy& occupancy() const { return *occupancy_; }

    // Made when it is first asked for: few write inputs.
    MoveInputs& inputs() const {
        if (!inputs_) inputs_ = std::make_unique<MoveInputs>(world_->config());
        return *inputs_;
    }

    Observer* observer = nullptr;                   // for views
    const EpisodeStatistics* statistics = nullptr;  // for EpisodeEnd: of the ended episode
    bool acts = false;   // for StepStart: whether the living agents act in this step
    bool ended = false;  // whether the episode ended in this step

  private:
    const World* world_ = nullptr;
    const Occupancy* occupancy_ = nullptr;  // must hold the world's agents
    std::size_t n_agents_ = 0;              // kept here, because nearly all writers need it
    mutable std::unique_ptr<MoveInputs> inputs_;
};

// Writes one world's part of an array, all of it.
using Writer = void (*)(const OutputSource& source, void* out);

struct OutputField {
    std::string name;
    DType dtype;
    Axes axes;
    Written written;
    Writer write;
    Writer write_floats = nullptr;  // the same as float32, where an array may be either

    std::size_t n_items(const Config& config) const;  // of one world
};

using OutputFields = std::vector<OutputField>;
const OutputFields& world_fields();  // of a world, alone or in a batch
const OutputFields& batch_fields();  // what a batch adds: about its steps and its episodes
// The field of this name, or null.
const OutputField* find_field(const OutputFields& fields, const std::string& name);

// A member of EpisodeStatistics as an output. A rollout returns each of them.
struct StatisticField {
    OutputField field;
    bool in_batch;  // whether it is among `batch_fields`, as "episode_" + name
    bool by_team;   // whether a rollout returns one array for each team, "pursuer_" + name, ...
};
const std::vector<StatisticField>& statistic_fields();

}  // namespace matrixworld
