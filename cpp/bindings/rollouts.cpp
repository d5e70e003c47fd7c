// Networks, rollouts and recorded episodes for Python.
#include <pybind11/stl.h>

#include <string>

#include "bindings/bindings.hpp"
#include "bindings/candidates.hpp"
#include "bindings/numpy_arrays.hpp"
#include "bindings/numpy_buffers.hpp"
#include "bindings/signals.hpp"
#include "play/program.hpp"
#include "play/rollout.hpp"

namespace matrixworld {

namespace {

// Python names activations; the engine's None is not among them, it is for the last layer.
Network make_network(int fov, const std::vector<int>& hidden, int n_actions,
                     const std::string& activation, bool sampled, const std::string& memory) {
    if (activation != "relu" && activation != "tanh") {
        throw py::value_error("activation: expected 'relu' or 'tanh', got '" + activation + "'");
    }
    return Network(fov, hidden, n_actions,
                   activation == "relu" ? Activation::Relu : Activation::Tanh, sampled,
                   to_memory(memory));
}

RatingShape make_rating(int fov, int n_actions, std::vector<int> inputs, std::vector<int> hidden,
                        int length, const std::string& mask) {
    RatingShape shape{fov, n_actions, std::move(inputs), std::move(hidden), length, to_mask(mask)};
    shape.validate();
    return shape;
}

void check_genomes(const RatingShape& shape, const Array<float>& genomes) {
    require_shape("genomes", genomes, {genomes.shape(0), shape.genome_size()});
    shape.check_genomes(genomes.data(), static_cast<std::size_t>(genomes.shape(0)));
}

// (name, definition, unit, largest value or 0) of each input.
py::list inputs() {
    py::list rows;
    for (const InputText& text : input_texts()) {
        rows.append(py::make_tuple(text.name, text.definition, text.unit, text.most));
    }
    return rows;
}

// (name, number of arguments) of each operation of programs.
py::list operations_of_programs() {
    py::list rows;
    for (const Operation& operation : operations()) {
        rows.append(py::make_tuple(operation.name, operation.n_arguments));
    }
    return rows;
}

// One statistic of all episodes, (M, W, ...).
py::array to_column(const OutputField& field, const std::vector<EpisodeStatistics>& statistics,
                    const Config& config, const Shape& leading) {
    py::array column(numpy_dtype(field.dtype), shape_of(field, config, leading));
    auto* out = static_cast<std::uint8_t*>(column.mutable_data());
    const std::size_t size = field.n_items(config) * item_size(field.dtype);
    OutputSource source;  // without a world: statistics need none
    for (const EpisodeStatistics& episode : statistics) {
        source.statistics = &episode;
        field.write(source, out);
        out += size;
    }
    return column;
}

// The arrays of all statistics by name. Those by team are returned as one array for each team.
py::dict to_columns(const std::vector<EpisodeStatistics>& statistics, const Config& config,
                    const Shape& leading) {
    py::dict out;
    for (const StatisticField& statistic : statistic_fields()) {
        const std::string& name = statistic.field.name;
        const py::array column = to_column(statistic.field, statistics, config, leading);
        if (!statistic.by_team) {
            out[name.c_str()] = column;
            continue;
        }
        for (int team = 0; team < kTeams; ++team) {
            const std::string prefix = team == 0 ? "pursuer_" : "evader_";
            const py::object part = column[py::make_tuple(py::ellipsis(), team)];
            out[(prefix + name).c_str()] = part.attr("copy")();  // contiguous
        }
    }
    return out;
}

py::dict rollout(const std::shared_ptr<const Setup>& setup, const py::object& pursuers,
                 const py::object& evaders, const Array<std::int32_t>& pursuer,
                 const Array<std::int32_t>& evader, const Array<std::uint64_t>& seed, int n_worlds,
                 int n_threads, bool one_by_one) {
    const HeldCandidates left = to_candidates("pursuers", pursuers, setup->config);
    const HeldCandidates right = to_candidates("evaders", evaders, setup->config);
    const py::ssize_t n = seed.size();
    require_shape("pursuer", pursuer, {n});
    require_shape("evader", evader, {n});
    require_shape("seed", seed, {n});
    // Genomes are looked up by pointer arithmetic later, so every index is checked here: in a copy,
    // to which no other thread can write.
    std::vector<Match> matches;
    matches.reserve(static_cast<std::size_t>(n));
    for (py::ssize_t i = 0; i < n; ++i) {
        matches.push_back({pursuer.at(i), evader.at(i), seed.at(i)});
        require_index("pursuer", matches.back().pursuer, left.candidates.n);
        require_index("evader", matches.back().evader, right.candidates.n);
    }
    // The arrays stay alive in `left` and `right`; no Python object is touched without the GIL.
    std::vector<EpisodeStatistics> statistics;
    const Workers::Poll poll = signal_poll();
    {
        const py::gil_scoped_release release;
        statistics = play_matches(setup, left.candidates, right.candidates, matches, n_worlds,
                                  n_threads, poll, one_by_one);
    }
    return to_columns(statistics, setup->config, {n, n_worlds});
}

// Output fields of one episode, moment after moment, in memory that grows.
class Recorder {
  public:
    Recorder(const Setup& setup, const std::vector<std::string>& of_moments,
             const std::vector<std::string>& of_steps)
        : config_(setup.config), observer_(setup) {
        source_.observer = &observer_;
        for (const std::string& name : of_moments) add_column(name, moments_);
        for (const std::string& name : of_steps) add_column(name, steps_);
    }

    void note(const World& world, const Occupancy& occupancy,
              const std::vector<std::uint8_t>* actions) {
        source_.look_at(world, occupancy);
        for (Column& column : moments_) append(column);
        ++n_moments_;
        if (!actions) return;  // the moment after the reset belongs to no step
        for (Column& column : steps_) append(column);
        actions_.insert(actions_.end(), actions->begin(), actions->end());
    }

    // Arrays of moments (T + 1, ...), arrays of steps and actions (T, ...).
    py::dict arrays() const {
        py::dict out;
        for (const Column& column : moments_) out[name(column)] = to_array(column, n_moments_);
        for (const Column& column : steps_) out[name(column)] = to_array(column, n_moments_ - 1);
        py::array_t<std::int8_t> actions({n_moments_ - 1, py::ssize_t{config_.n_agents()}});
        std::copy(actions_.begin(), actions_.end(), actions.mutable_data());
        out["actions"] = actions;
        return out;
    }

  private:
    // Bytes without a type: the field's own writer fills them, as it fills a batch's arrays.
    struct Column {
        const OutputField* field;
        std::size_t size;  // bytes of a moment
        std::vector<std::uint8_t> bytes;
    };

    // Only `record` of the package calls this, with names that are in the table.
    void add_column(const std::string& name, std::vector<Column>& columns) {
        const OutputField* field = find_field(world_fields(), name);
        if (!field) throw py::value_error("record: no field has the name '" + name + "'");
        columns.push_back({field, field->n_items(config_) * item_size(field->dtype), {}});
    }

    void append(Column& column) {
        column.bytes.resize(column.bytes.size() + column.size);
        column.field->write(source_, column.bytes.data() + column.bytes.size() - column.size);
    }

    static const char* name(const Column& column) { return column.field->name.c_str(); }

    py::array to_array(const Column& column, py::ssize_t length) const {
        const OutputField& field = *column.field;
        py::array array(numpy_dtype(field.dtype), shape_of(field, config_, {length}));
        std::copy(column.bytes.begin(), column.bytes.end(),
                  static_cast<std::uint8_t*>(array.mutable_data()));
        return array;
    }

    const Config& config_;
    Observer observer_;
    OutputSource source_;
    py::ssize_t n_moments_ = 0;
    std::vector<Column> moments_, steps_;
    std::vector<std::uint8_t> actions_;
};

py::dict record(const std::shared_ptr<const Setup>& setup, const py::object& pursuers,
                const py::object& evaders, int pursuer, int evader, std::uint64_t seed,
                std::uint64_t episode, const std::vector<std::string>& of_moments,
                const std::vector<std::string>& of_steps) {
    const HeldCandidates left = to_candidates("pursuers", pursuers, setup->config);
    const HeldCandidates right = to_candidates("evaders", evaders, setup->config);
    require_index("pursuer", pursuer, left.candidates.n);
    require_index("evader", evader, right.candidates.n);
    // The GIL is kept, because one episode is mostly short. If it is long, signals can end it.
    Recorder recorder(*setup, of_moments, of_steps);
    play_episode(setup, left.candidates, right.candidates, {pursuer, evader, seed}, episode,
                 [&](const World& world, const Occupancy& occupancy,
                     const std::vector<std::uint8_t>* actions) {
                     handle_signals();
                     recorder.note(world, occupancy, actions);
                 });
    return recorder.arrays();
}

}  // namespace

void bind_rollouts(py::module_& m) {
    py::class_<Network>(m, "Network")
        .def(py::init(&make_network), py::kw_only(), py::arg("fov"), py::arg("hidden"),
             py::arg("n_actions"), py::arg("activation"), py::arg("sampled"), py::arg("memory"));
    py::class_<RatingShape>(m, "Rating")
        .def(py::init(&make_rating), py::kw_only(), py::arg("fov"), py::arg("n_actions"),
             py::arg("inputs"), py::arg("hidden"), py::arg("length"), py::arg("mask"))
        .def("genome_size", &RatingShape::genome_size)
        .def("check", &check_genomes, py::arg("genomes"));
    m.def("inputs", &inputs);
    m.def("operations", &operations_of_programs);
    m.def("rollout", &rollout, py::arg("setup"), py::arg("pursuers"), py::arg("evaders"),
          py::arg("pursuer").noconvert(), py::arg("evader").noconvert(),
          py::arg("seed").noconvert(), py::arg("n_worlds"), py::arg("n_threads"),
          py::arg("one_by_one") = false);
    m.def("record", &record, py::arg("setup"), py::arg("pursuers"), py::arg("evaders"),
          py::arg("pursuer"), py::arg("evader"), py::arg("seed"), py::arg("episode"),
          py::arg("of_moments"), py::arg("of_steps"));
}

}  // namespace matrixworld
