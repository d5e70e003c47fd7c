// The states of small worlds, and backward induction over them, for Python.
#include <pybind11/stl.h>

#include "bindings/bindings.hpp"
#include "bindings/candidates.hpp"
#include "bindings/numpy_arrays.hpp"
#include "bindings/signals.hpp"
#include "solve/states.hpp"
#include "solve/table_policy.hpp"

namespace matrixworld {

namespace {

using Doubles = py::array_t<double, py::array::c_style>;

void require_turn(const States& states, int turn) { require_index("turn", turn, states.n_turns()); }

// An array that shows memory of the states and keeps them alive.
py::array shown(const py::object& self, const std::vector<std::int32_t>& numbers,
                const Shape& shape) {
    py::array_t<std::int32_t> array(shape, numbers.data(), self);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::array successors(const py::object& self, int turn) {
    const auto& states = self.cast<const States&>();
    require_turn(states, turn);
    return shown(self, states.successors(turn),
                 shape(states.n_states(turn), states.n_joint(turn, Team::Pursuer),
                       states.n_joint(turn, Team::Evader)));
}

py::array starts(const py::object& self) {
    const auto& states = self.cast<const States&>();
    return shown(self, states.starts(), shape(states.starts().size()));
}

// Cells (n, A) int32, as row * cols + col, and captured (n, E) bool, of all states of a turn.
py::tuple describe(const States& states, int turn) {
    require_turn(states, turn);
    const Config& config = states.setup().config;
    py::array_t<std::int32_t> cells({states.n_states(turn), std::int64_t{config.n_agents()}});
    py::array_t<bool> captured({states.n_states(turn), std::int64_t{config.n_evaders}});
    static_assert(sizeof(bool) == sizeof(std::uint8_t));
    for (std::int64_t state = 0; state < states.n_states(turn); ++state) {
        states.describe(turn, state, cells.mutable_data(state, 0),
                        reinterpret_cast<std::uint8_t*>(captured.mutable_data(state, 0)));
    }
    return py::make_tuple(cells, captured);
}

const double* given_by(const char* name, const std::optional<Doubles>& given, const States& states,
                       int turn, Team team) {
    if (!given) return nullptr;
    require_shape(name, *given, shape(states.n_states(turn), states.n_joint(turn, team)));
    return given->data();
}

py::tuple backup(const States& states, int turn, const Doubles& next,
                 const std::optional<Doubles>& pursuers, const std::optional<Doubles>& evaders,
                 bool chosen, int n_threads, const py::object& report) {
    require_turn(states, turn);
    require_shape("next", next, shape(states.n_states((turn + 1) % states.n_turns())));
    Doubles values(states.n_states(turn));
    States::Play play;
    play.given[0] = given_by("pursuers", pursuers, states, turn, Team::Pursuer);
    play.given[1] = given_by("evaders", evaders, states, turn, Team::Evader);
    py::object by_team[kTeams] = {py::none(), py::none()};
    for (Team team : {Team::Pursuer, Team::Evader}) {
        if (!chosen || play.given[static_cast<int>(team)]) continue;
        Doubles probabilities({states.n_states(turn), std::int64_t{states.n_joint(turn, team)}});
        play.chosen[static_cast<int>(team)] = probabilities.mutable_data();
        by_team[static_cast<int>(team)] = probabilities;
    }
    double gap = 0;
    double* const out = values.mutable_data();
    const States::Poll poll = signal_poll(report);
    {
        const py::gil_scoped_release release;
        gap = states.backup(turn, next.data(), out, play, n_threads, poll);
    }
    return py::make_tuple(values, gap, by_team[0], by_team[1]);
}

// The probabilities with which a policy plays in a step of an episode, (n_states, its joint actions).
Doubles weigh(const States& states, int turn, Team team, const py::object& policy,
              States::When when, int n_threads, const py::object& report) {
    require_turn(states, turn);
    const HeldCandidates held = to_policy("champion", policy, states.setup().config);
    Doubles out({states.n_states(turn), std::int64_t{states.n_joint(turn, team)}});
    double* const probabilities = out.mutable_data();
    const States::Poll poll = signal_poll(report);
    const py::gil_scoped_release release;
    states.weigh(turn, team, held.candidates, when, probabilities, n_threads, poll);
    return out;
}

bool counts_steps(const States& states, const py::object& policy) {
    const HeldCandidates held = to_policy("champion", policy, states.setup().config);
    return LoadedPolicy(held.candidates, states.setup()).load(0).counts_steps();
}

bool draws_strides(const States& states, const py::object& policy) {
    const HeldCandidates held = to_policy("champion", policy, states.setup().config);
    return LoadedPolicy(held.candidates, states.setup()).load(0).draws_strides();
}

// Episodes of the seed 0.
States::When when_of(int step, std::uint64_t episode) { return {{0, episode}, step}; }

// The named inputs of an agent in some states of a turn, (n, moves, inputs) float32.
py::array_t<float> look(const States& states, int turn, int agent, int step, std::uint64_t episode,
                        const Array<std::int32_t>& of) {
    require_turn(states, turn);
    require_index("agent", agent, states.setup().config.n_agents());
    require_shape("states", of, shape(of.size()));
    for (py::ssize_t i = 0; i < of.size(); ++i) {
        require_index("state", of.data()[i], states.n_states(turn));
    }
    py::array_t<float> out(shape(of.size(), states.setup().config.n_actions(), kInputs));
    states.look(turn, agent, when_of(step, episode), of.data(), static_cast<std::size_t>(of.size()),
                out.mutable_data());
    return out;
}

// Copies the rows, (rounds, n_states, joint actions) float32 for each turn.
std::shared_ptr<Tables> make_tables(const std::shared_ptr<States>& states, Team team, int steps,
                                    const std::vector<Array<float>>& by_turn) {
    auto tables = std::make_shared<Tables>(Tables{states, team, 0, steps, {}});
    if (static_cast<int>(by_turn.size()) != states->n_turns()) {
        throw py::value_error("tables: expected " + std::to_string(states->n_turns()) + ", got " +
                              std::to_string(by_turn.size()));
    }
    for (int turn = 0; turn < states->n_turns(); ++turn) {
        const Array<float>& rows = by_turn[turn];
        const py::ssize_t n_rounds = by_turn[0].ndim() ? by_turn[0].shape(0) : 0;
        require_shape("table", rows,
                      shape(n_rounds, states->n_states(turn), states->n_joint(turn, team)));
        tables->n_rounds = static_cast<int>(n_rounds);
        tables->by_turn.emplace_back(rows.data(), rows.data() + rows.size());
    }
    return tables;
}

Team team_of(bool evaders) { return evaders ? Team::Evader : Team::Pursuer; }

}  // namespace

void bind_solve(py::module_& m) {
    py::class_<States, std::shared_ptr<States>>(m, "States")
        .def(py::init([](const std::shared_ptr<const Setup>& setup, int n_threads,
                         std::size_t expected, const py::object& report, bool numbered) {
                 const States::Poll poll = signal_poll(report);
                 const py::gil_scoped_release release;
                 return std::make_shared<States>(setup, n_threads, poll, expected, numbered);
             }),
             py::arg("setup"), py::arg("n_threads"), py::arg("expected"), py::arg("report"),
             py::arg("numbered"))
        .def("n_turns", &States::n_turns)
        .def("describe", &describe, py::arg("turn"))
        .def("successors", &successors, py::arg("turn"))
        .def("starts", &starts)
        .def(
            "weigh",
            [](const States& states, int turn, bool evaders, const py::object& policy, int step,
               std::uint64_t episode, int n_threads, const py::object& report) {
                return weigh(states, turn, team_of(evaders), policy, when_of(step, episode),
                             n_threads, report);
            },
            py::arg("turn"), py::arg("evaders"), py::arg("policy"), py::arg("step"),
            py::arg("episode"), py::arg("n_threads"), py::arg("report"))
        .def("counts_steps", &counts_steps, py::arg("policy"))
        .def("draws_strides", &draws_strides, py::arg("policy"))
        .def("look", &look, py::arg("turn"), py::arg("agent"), py::arg("step"), py::arg("episode"),
             py::arg("states"))
        .def("backup", &backup, py::arg("turn"), py::arg("next").noconvert(),
             py::arg("pursuers").none(true).noconvert(), py::arg("evaders").none(true).noconvert(),
             py::arg("chosen"), py::arg("n_threads"), py::arg("report"));
    py::class_<Tables, std::shared_ptr<Tables>>(m, "Tables")
        .def(py::init([](const std::shared_ptr<States>& states, bool evaders, int steps,
                         const std::vector<Array<float>>& by_turn) {
                 return make_tables(states, team_of(evaders), steps, by_turn);
             }),
             py::arg("states"), py::arg("evaders"), py::arg("steps"), py::arg("by_turn"));
}

}  // namespace matrixworld
