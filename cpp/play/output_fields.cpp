#include "play/output_fields.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

namespace matrixworld {

namespace {

// ---- Rows of the table --------------------------------------------------------------------------

template <typename T>
constexpr DType dtype_of() {
    // NumPy's numbers have the same sizes and formats.
    if constexpr (std::is_same_v<T, bool>) return DType::Bool;
    if constexpr (std::is_same_v<T, std::uint8_t>) return DType::UInt8;
    if constexpr (std::is_same_v<T, std::int32_t>) return DType::Int32;
    if constexpr (std::is_same_v<T, std::int64_t>) return DType::Int64;
    if constexpr (std::is_same_v<T, std::uint64_t>) return DType::UInt64;
    if constexpr (std::is_same_v<T, float>) return DType::Float32;
    if constexpr (std::is_same_v<T, double>) return DType::Float64;
}
static_assert(sizeof(bool) == 1, "NumPy's bool is one byte");

template <typename T>
constexpr DType dtype_of(void (*)(const OutputSource&, T*)) {
    return dtype_of<T>();
}

// A writer with its pointer's type hidden, so that one table holds all writers. The cast is safe
// because `field` takes the row's dtype from the same writer.
template <auto kWrite, typename T>
void write_untyped(const OutputSource& source, void* out) {
    kWrite(source, static_cast<T*>(out));
}

template <auto kWrite, typename T>
constexpr Writer untyped(void (*)(const OutputSource&, T*)) {
    return write_untyped<kWrite, T>;
}

// A row of which the dtype is what the writer's second parameter points to.
template <auto kWrite>
OutputField field(const char* name, Axes axes, Written written) {
    return {name, dtype_of(kWrite), std::move(axes), written, untyped<kWrite>(kWrite)};
}

// ---- Writers: the moment ------------------------------------------------------------------------

// All bits if there is no cell, else none. With it, writers need no branch: which agents are gone
// cannot be predicted.
int gone_bits(int cell) {
    static_assert(kGone == -1, "all bits are set");
    return cell >> 31;
}

// Row and column of a cell; kGone, kGone without one.
void write_cell(const Grid& grid, int cell, std::int32_t* out) {
    const int gone = gone_bits(cell);
    const int row = grid.row(cell & ~gone);
    out[0] = row | gone;
    out[1] = (cell - grid.cell(row, 0)) | gone;
}

void write_positions(const OutputSource& source, std::int32_t* out) {
    const World& world = source.world();
    const int* cells = world.cells().data();
    for (std::size_t a = 0; a < source.n_agents(); ++a) {
        write_cell(world.grid(), cells[a], out + 2 * a);
    }
}

void write_last_positions(const OutputSource& source, std::int32_t* out) {
    const World& world = source.world();
    const int* cells = world.cells().data();
    const int* last_cells = world.last_cells().data();
    for (std::size_t a = 0; a < source.n_agents(); ++a) {
        const int gone = gone_bits(cells[a]);
        write_cell(world.grid(), (last_cells[a] & gone) | (cells[a] & ~gone), out + 2 * a);
    }
}

void write_alive(const OutputSource& source, bool* out) {
    const int* cells = source.world().cells().data();
    for (std::size_t a = 0; a < source.n_agents(); ++a) out[a] = cells[a] != kGone;
}

void write_steps(const OutputSource& source, std::int32_t* out) { *out = source.world().steps(); }

void write_seed(const OutputSource& source, std::uint64_t* out) {
    *out = source.world().key().seed;
}

void write_episode(const OutputSource& source, std::uint64_t* out) {
    *out = source.world().key().episode;
}

template <typename Number>
void write_views(const OutputSource& source, Number* out) {
    source.observer->write(source.world(), source.occupancy(), out);
}

void write_whole_state(const OutputSource& source, std::uint8_t* out) {
    write_state(source.world(), out);
}

void write_inputs(const OutputSource& source, float* out) {
    source.inputs().write(source.world(), source.occupancy(), out);
}

OutputField views(const char* name, Written written) {
    OutputField row = field<write_views<std::uint8_t>>(
        name, {Axis::Agents, Axis::Channels, Axis::Fov, Axis::Fov}, written);
    row.write_floats = untyped<write_views<float>>(write_views<float>);
    return row;
}

// ---- Writers: the last step ---------------------------------------------------------------------

template <const ByteArray& (World::*kRead)() const>
void write_evader_flags(const OutputSource& source, bool* out) {
    const ByteArray& flags = (source.world().*kRead)();  // each 0 or 1, as a bool
    std::memcpy(out, flags.data(), static_cast<std::size_t>(flags.size()));
}

void write_captors(const OutputSource& source, std::int32_t* out) {
    const IntArray& captors = source.world().captors();
    std::copy_n(captors.data(), captors.size(), out);
}

// Bits [kFirstBit, kFirstBit + kKinds) of the agents' reports. Few agents have a report, so all
// entries are cleared at once and those of few are set.
template <int kFirstBit>
void write_report_bits(const OutputSource& source, bool* out) {
    std::fill_n(out, source.n_agents() * kKinds, false);
    for (const int a : source.world().reported()) {
        const Flags report = source.world().report(a);
        for (int kind = 0; kind < kKinds; ++kind) {
            out[a * kKinds + kind] = report >> (kFirstBit + kind) & 1;
        }
    }
}

void write_cost(const OutputSource& source, float* out) {
    std::fill_n(out, source.n_agents(), 0.0f);
    for (const int a : source.world().reported()) {
        const Flags report = source.world().report(a);
        for (int kind = 0; kind < kKinds; ++kind) out[a] += report >> (kKinds + kind) & 1;
    }
}

void write_rewards(const OutputSource& source, float* out) {
    std::copy_n(source.world().rewards().data(), source.n_agents(), out);
}

void write_terminations(const OutputSource& source, bool* out) {
    const bool all_end = source.world().terminated();
    const int* cells = source.world().cells().data();
    for (std::size_t a = 0; a < source.n_agents(); ++a) out[a] = all_end || cells[a] == kGone;
}

void write_truncations(const OutputSource& source, bool* out) {
    if (source.world().truncated() && !source.world().terminated()) {
        write_alive(source, out);
    } else {
        std::fill_n(out, source.n_agents(), false);
    }
}

void write_terminated(const OutputSource& source, bool* out) { *out = source.world().terminated(); }
void write_truncated(const OutputSource& source, bool* out) { *out = source.world().truncated(); }

float share(int count, int of) { return static_cast<float>(static_cast<double>(count) / of); }

void write_capture_rate(const OutputSource& source, float* out) {
    *out = share(source.world().n_captured(), source.world().config().n_evaders);
}

void write_ever_capture_rate(const OutputSource& source, float* out) {
    *out = share(source.world().n_ever_captured(), source.world().config().n_evaders);
}

void write_survival_rate(const OutputSource& source, float* out) {
    const World& world = source.world();
    out[0] = share(world.n_living(Team::Pursuer), world.config().n_pursuers);
    out[1] = share(world.n_living(Team::Evader), world.config().n_evaders);
}

// ---- Writers: batches ---------------------------------------------------------------------------

void write_acted(const OutputSource& source, bool* out) {
    if (source.acts) {
        write_alive(source, out);
    } else {
        std::fill_n(out, source.n_agents(), false);
    }
}

void write_ended(const OutputSource& source, bool* out) { *out = source.ended; }

// ---- Statistics of an episode -------------------------------------------------------------------

// The type of a statistic's numbers: of a member that is a number, or an array of numbers.
template <typename T>
struct ItemOf {
    using Type = T;
};
template <typename T, std::size_t kSize>
struct ItemOf<std::array<T, kSize>> {
    using Type = T;
};

template <auto kMember>
void write_statistic(const OutputSource& source, void* out) {
    const auto& value = source.statistics->*kMember;  // a number, or a std::array of numbers
    std::memcpy(out, &value, sizeof(value));
}

enum class Share : std::uint8_t { RolloutOnly, WithBatch };
enum class Split : std::uint8_t { Whole, ByTeam };

template <auto kMember>
StatisticField statistic(const char* name, Axes axes, Share share, Split split = Split::Whole) {
    using Value = std::decay_t<decltype(std::declval<EpisodeStatistics>().*kMember)>;
    constexpr DType dtype = dtype_of<typename ItemOf<Value>::Type>();
    return {{name, dtype, std::move(axes), Written::EpisodeEnd, write_statistic<kMember>},
            share == Share::WithBatch,
            split == Split::ByTeam};
}

}  // namespace

// ---- The tables ---------------------------------------------------------------------------------

const OutputFields& world_fields() {
    const Axes none, agents{Axis::Agents}, evaders{Axis::Evaders};
    const Axes cells{Axis::Agents, Axis::RowCol}, by_kind{Axis::Agents, Axis::Kinds};
    const Axes by_input{Axis::Agents, Axis::Moves, Axis::Inputs};
    static const OutputFields fields = {
        field<write_positions>("positions", cells, Written::Moment),
        field<write_last_positions>("last_positions", cells, Written::Moment),
        field<write_alive>("alive", agents, Written::Moment),
        field<write_evader_flags<&World::captured>>("captured", evaders, Written::Step),
        field<write_evader_flags<&World::ever_captured>>("ever_captured", evaders, Written::Step),
        field<write_captors>("captors", evaders, Written::Step),
        field<write_report_bits<0>>("involved", by_kind, Written::Step),
        field<write_report_bits<kKinds>>("fault", by_kind, Written::Step),
        field<write_cost>("cost", agents, Written::Step),
        field<write_rewards>("rewards", agents, Written::Step),
        field<write_terminations>("terminations", agents, Written::Step),
        field<write_truncations>("truncations", agents, Written::Step),
        field<write_steps>("steps", none, Written::Moment),
        field<write_seed>("seed", none, Written::Moment),
        field<write_episode>("episode", none, Written::Moment),
        field<write_terminated>("terminated", none, Written::Step),
        field<write_truncated>("truncated", none, Written::Step),
        field<write_capture_rate>("capture_rate", none, Written::Step),
        field<write_ever_capture_rate>("ever_capture_rate", none, Written::Step),
        field<write_survival_rate>("survival_rate", {Axis::Teams}, Written::Step),
        views("views", Written::Moment),
        field<write_inputs>("inputs", by_input, Written::Moment),
        field<write_whole_state>("state", {Axis::Channels, Axis::Rows, Axis::Cols},
                                 Written::Moment),
    };
    return fields;
}

const std::vector<StatisticField>& statistic_fields() {
    using S = EpisodeStatistics;
    const Axes none, teams{Axis::Teams}, by_kind{Axis::Teams, Axis::Kinds};
    static const std::vector<StatisticField> fields = {
        statistic<&S::capture_rate>("capture_rate", none, Share::WithBatch),
        statistic<&S::ever_capture_rate>("ever_capture_rate", none, Share::WithBatch),
        statistic<&S::captured_fraction>("captured_fraction", none, Share::RolloutOnly),
        statistic<&S::length>("length", none, Share::WithBatch),
        statistic<&S::returns>("return", teams, Share::WithBatch, Split::ByTeam),
        statistic<&S::survivors>("survivors", teams, Share::WithBatch, Split::ByTeam),
        statistic<&S::overlap>("overlap", teams, Share::RolloutOnly, Split::ByTeam),
        statistic<&S::collisions>("collisions", by_kind, Share::WithBatch),
        statistic<&S::faults>("faults", by_kind, Share::WithBatch),
        statistic<&S::agent_steps>("agent_steps", teams, Share::WithBatch),
    };
    return fields;
}

const OutputFields& batch_fields() {
    static const OutputFields fields = [] {
        OutputFields rows = {
            field<write_acted>("acted", {Axis::Agents}, Written::StepStart),
            field<write_ended>("ended", {}, Written::Step),
            views("final_views", Written::EpisodeEnd),
            field<write_inputs>("final_inputs", {Axis::Agents, Axis::Moves, Axis::Inputs},
                                Written::EpisodeEnd),
        };
        // The rows of a rollout's statistics, under names of their own.
        for (const StatisticField& statistic : statistic_fields()) {
            if (!statistic.in_batch) continue;
            rows.push_back(statistic.field);
            rows.back().name = "episode_" + statistic.field.name;
        }
        return rows;
    }();
    return fields;
}

const OutputField* find_field(const OutputFields& fields, const std::string& name) {
    const auto has_name = [&](const OutputField& field) { return field.name == name; };
    const auto found = std::find_if(fields.begin(), fields.end(), has_name);
    return found == fields.end() ? nullptr : &*found;
}

// ---- Sizes --------------------------------------------------------------------------------------

std::size_t item_size(DType dtype) {
    switch (dtype) {
        case DType::Bool:
        case DType::UInt8:
            return 1;
        case DType::Int32:
        case DType::Float32:
            return 4;
        default:
            return 8;
    }
}

const char* name_of(Axis axis) {
    static constexpr const char* kNames[kAxes] = {"agents",  "evaders",  "teams", "kinds",
                                                  "row_col", "channels", "fov",   "rows",
                                                  "cols",    "moves",    "inputs"};
    return kNames[static_cast<int>(axis)];
}

int size_of(Axis axis, const Config& config) {
    const int sizes[kAxes] = {config.n_agents(),
                              config.n_evaders,
                              kTeams,
                              kKinds,
                              2,
                              kChannels,
                              config.fov,
                              config.rows,
                              config.cols,
                              config.n_actions(),
                              kInputs};
    return sizes[static_cast<int>(axis)];
}

std::size_t OutputField::n_items(const Config& config) const {
    std::size_t n = 1;
    for (const Axis axis : axes) n *= static_cast<std::size_t>(size_of(axis, config));
    return n;
}

}  // namespace matrixworld
