// The extension module `matrixworld._core`: enumerations, rules, rewards, setup, and the table of
// output fields. Only the files of this folder know Python. They check shapes and dtypes while they
// hold the GIL, then release it and call the engine.
#include "bindings/bindings.hpp"

#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include <array>
#include <exception>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "bindings/numpy_arrays.hpp"
#include "bindings/numpy_buffers.hpp"
#include "kernels/kernels.hpp"
#include "observe/right_of_way.hpp"
#include "play/batch.hpp"

namespace py = pybind11;
using namespace matrixworld;

namespace {

// The constructor of Setup checks the ranges; whatever it throws reaches Python as ValueError.
std::shared_ptr<const Setup> make_setup(const Rules& rules, const Rewards& rewards, int rows,
                                        int cols, int n_pursuers, int n_evaders, int fov,
                                        bool diagonal, int max_steps, double density,
                                        const py::object& map) {
    Config config;
    config.rules = rules;
    config.rewards = rewards;
    config.rows = rows;
    config.cols = cols;
    config.n_pursuers = n_pursuers;
    config.n_evaders = n_evaders;
    config.fov = fov;
    config.diagonal = diagonal;
    config.max_steps = max_steps;
    config.density = density;
    config.map = to_map(map);
    return std::make_shared<const Setup>(std::move(config));
}

// Arrays by team: (pursuer, evader).
Rewards make_rewards(std::array<float, kTeams> capture, std::array<float, kTeams> neighbor,
                     std::array<std::array<float, kKinds>, kTeams> collide,
                     std::array<float, kTeams> step, Blame blame, bool capture_repeats) {
    Rewards rewards;
    for (int team = 0; team < kTeams; ++team) {
        rewards.capture[team] = capture[team];
        rewards.neighbor[team] = neighbor[team];
        std::copy(collide[team].begin(), collide[team].end(), rewards.collide[team]);
        rewards.step[team] = step[team];
    }
    rewards.blame = blame;
    rewards.capture_repeats = capture_repeats;
    return rewards;
}

const char* name_of(Written when) {
    switch (when) {
        case Written::Moment:
            return "moment";
        case Written::Step:
            return "step";
        case Written::StepStart:
            return "step start";
        default:
            return "episode end";
    }
}

// (name, dtype, names of axes, when it is written) of each field.
py::list to_list(const OutputFields& fields) {
    py::list rows;
    for (const OutputField& field : fields) {
        py::tuple axes(field.axes.size());
        for (std::size_t i = 0; i < field.axes.size(); ++i) axes[i] = name_of(field.axes[i]);
        rows.append(
            py::make_tuple(field.name, numpy_dtype(field.dtype), axes, name_of(field.written)));
    }
    return rows;
}

// Python computes shapes from these and the fields' axes.
py::dict axis_sizes(const Setup& setup) {
    py::dict sizes;
    for (int i = 0; i < kAxes; ++i) {
        const auto axis = static_cast<Axis>(i);
        sizes[name_of(axis)] = size_of(axis, setup.config);
    }
    return sizes;
}

// What forbids each move by the right of way: (channel, row, column) from the agent. In the order of
// a step, or in that of networks.
py::list right_of_way(const Setup& setup, bool evaders, std::optional<int> step) {
    const RightOfWay ways(setup.config, evaders ? Team::Evader : Team::Pursuer);
    py::list moves;
    for (int move = 0; move < setup.config.n_actions(); ++move) {
        py::list cells;
        for (const RightOfWay::Cell& cell :
             step ? ways.forbidding(RightOfWay::order(*step), move) : ways.forbidding(move)) {
            cells.append(py::make_tuple(cell.channel, cell.row, cell.col));
        }
        moves.append(cells);
    }
    return moves;
}

// For draws that belong to no world, such as the choice of an opponent, with purposes of their own.
std::array<std::uint64_t, 4> philox_block(std::array<std::uint64_t, 4> counter,
                                          std::array<std::uint64_t, 2> key) {
    return philox(counter, key[0], key[1]);
}

}  // namespace

// Enumerations become Python's own (`enum.Enum`), with the names that the package exports. Keyword
// arguments only: a long row of numbers in a fixed order would be easy to get wrong.
//
// No GIL is needed: setups and networks never change, a world's methods take its lock, a batch refuses
// a second caller, and rollouts share nothing (see locked.hpp and in_use.hpp).
PYBIND11_MODULE(_core, m, py::mod_gil_not_used()) {
    m.doc() = "The engine of matrixworld. Use it through the package.";

    // Threads that the system does not start, such as beyond the limit of `ulimit -u`.
    py::register_local_exception_translator([](std::exception_ptr problem) {
        try {
            std::rethrow_exception(std::move(problem));
        } catch (const std::system_error& error) {
            const std::string expected = "threads: expected the system to start more, got: ";
            py::set_error(PyExc_OSError, (expected + error.what()).c_str());
        }
    });

    py::native_enum<Outcome>(m, "Outcome", "enum.Enum", "What a collision does to an agent.")
        .value("DISAPPEAR", Outcome::Disappear)
        .value("REACH", Outcome::Reach)
        .value("BOUNCE", Outcome::Bounce)
        .finalize();
    py::native_enum<Interaction>(m, "Interaction", "enum.Enum",
                                 "Which agents move at the same time.")
        .value("SIMULTANEOUS", Interaction::Simultaneous)
        .value("SWARM_TURNS", Interaction::SwarmTurns)
        .value("AGENT_TURNS", Interaction::AgentTurns)
        .finalize();
    py::native_enum<Capture>(m, "Capture", "enum.Enum", "How an evader is captured.")
        .value("OCCUPATION", Capture::Occupation)
        .value("SURROUND", Capture::Surround)
        .finalize();
    py::native_enum<Blame>(m, "Blame", "enum.Enum", "Which agents pay for a collision.")
        .value("FAULT", Blame::Fault)
        .value("INVOLVED", Blame::Involved)
        .finalize();
    py::native_enum<Autoreset>(m, "Autoreset", "enum.Enum",
                               "What a batch does with a world whose episode has ended.")
        .value("DISABLED", Autoreset::Disabled)
        .value("NEXT_STEP", Autoreset::NextStep)
        .value("SAME_STEP", Autoreset::SameStep)
        .finalize();

    py::class_<Rules>(m, "Rules")
        .def(py::init<Interaction, Outcome, Outcome, Outcome, Outcome, Capture, bool>(),
             py::kw_only(), py::arg("interaction"), py::arg("obstacle"), py::arg("teammate"),
             py::arg("evader"), py::arg("pursuer"), py::arg("capture"),
             py::arg("captured_disappear"));
    py::class_<Rewards>(m, "Rewards")
        .def(py::init(&make_rewards), py::kw_only(), py::arg("capture"), py::arg("neighbor"),
             py::arg("collide"), py::arg("step"), py::arg("blame"), py::arg("capture_repeats"));
    py::class_<Setup, std::shared_ptr<Setup>>(m, "Setup")
        .def(py::init([](const Rules& rules, const Rewards& rewards, int rows, int cols,
                         int n_pursuers, int n_evaders, int fov, bool diagonal, int max_steps,
                         double density, const py::object& map) {
                 // pybind11's holders are not const; the engine never changes a setup.
                 return std::const_pointer_cast<Setup>(
                     make_setup(rules, rewards, rows, cols, n_pursuers, n_evaders, fov, diagonal,
                                max_steps, density, map));
             }),
             py::kw_only(), py::arg("rules"), py::arg("rewards"), py::arg("rows"), py::arg("cols"),
             py::arg("n_pursuers"), py::arg("n_evaders"), py::arg("fov"), py::arg("diagonal"),
             py::arg("max_steps"), py::arg("density"), py::arg("map"))
        .def("axis_sizes", &axis_sizes);

    m.def("world_fields", [] { return to_list(world_fields()); });
    m.def("batch_fields", [] { return to_list(batch_fields()); });
    m.def("right_of_way", &right_of_way, py::arg("setup"), py::arg("evaders"),
          py::arg("step") = py::none());
    bind_worlds(m);
    bind_rollouts(m);
    bind_solve(m);
    m.def("philox", &philox_block, py::arg("counter"), py::arg("key"));
    m.def("kernel_level", [] { return kernels().level; });
}
