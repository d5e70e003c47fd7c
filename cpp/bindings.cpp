// The only file that knows Python: checks shapes and dtypes, then releases the GIL.
#include <pybind11/native_enum.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <map>
#include <optional>
#include <string>

#include "batch.hpp"
#include "observe.hpp"
#include "rollout.hpp"

namespace py = pybind11;
using namespace matrixworld;

namespace {

template <typename T>
using Array = py::array_t<T, py::array::c_style>;
using Shape = std::vector<py::ssize_t>;

std::string text(const Shape& shape) {
    std::string out = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) {
        out += (i ? ", " : "") + std::to_string(shape[i]);
    }
    return out + (shape.size() == 1 ? ",)" : ")");
}

Shape shape_of(const py::array& array) {
    return Shape(array.shape(), array.shape() + array.ndim());
}

void require_shape(const std::string& name, const py::array& array, const Shape& expected) {
    if (shape_of(array) == expected) return;
    throw py::value_error(name + ": expected shape " + text(expected) + ", got " +
                          text(shape_of(array)));
}

template <typename T>
void require_dtype(const std::string& name, const py::array& array) {
    if (array.dtype().is(py::dtype::of<T>())) return;
    throw py::type_error(name + ": expected dtype " +
                         py::str(py::dtype::of<T>()).cast<std::string>() + ", got " +
                         py::str(array.dtype()).cast<std::string>());
}

// ---- Setup ----------------------------------------------------------------------------------------

ByteArray to_map(const py::object& map) {
    if (map.is_none()) return {};
    const auto array = map.cast<Array<std::uint8_t>>();
    return Eigen::Map<const ByteArray>(array.data(), array.size());
}

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

// By team: (pursuer, evader).
Rewards make_rewards(std::array<float, kTeams> capture, std::array<float, kTeams> neighbor,
                     std::array<float, kTeams> collide, std::array<float, kTeams> step,
                     bool capture_repeats) {
    Rewards rewards;
    for (int team = 0; team < kTeams; ++team) {
        rewards.capture[team] = capture[team];
        rewards.neighbor[team] = neighbor[team];
        rewards.collide[team] = collide[team];
        rewards.step[team] = step[team];
    }
    rewards.capture_repeats = capture_repeats;
    return rewards;
}

// ---- Buffers ----------------------------------------------------------------------------------------

// The caller's arrays, checked, with what keeps them alive.
struct HeldBuffers {
    Buffers pointers;
    py::dict arrays;
};

Shape joined(Shape lead, const Shape& rest) {
    lead.insert(lead.end(), rest.begin(), rest.end());
    return lead;
}

HeldBuffers hold(const Config& config, const Shape& lead, const py::dict& arrays) {
    HeldBuffers held;
    held.arrays = arrays;
    const py::ssize_t n_agents = config.n_agents();
    const py::ssize_t n_evaders = config.n_evaders;
    std::size_t known = 0;
    const auto take = [&](const char* name, auto*& pointer, const Shape& shape, auto... dtypes) {
        if (!arrays.contains(name)) return;
        ++known;
        const py::object object = arrays[name];
        if (!py::isinstance<py::array>(object)) {
            throw py::type_error(std::string(name) + ": expected a NumPy array, got " +
                                 py::type::of(object).attr("__name__").cast<std::string>());
        }
        auto array = py::reinterpret_borrow<py::array>(object);
        using T = std::remove_reference_t<decltype(*pointer)>;
        if (!(array.dtype().is(py::dtype::of<decltype(dtypes)>()) || ...))
            require_dtype<T>(name, array);
        require_shape(name, array, joined(lead, shape));
        if (!(array.flags() & py::array::c_style) || !array.writeable()) {
            throw py::value_error(std::string(name) + ": expected a writeable C-contiguous array");
        }
        pointer = static_cast<T*>(array.mutable_data());
    };
    Buffers& b = held.pointers;
    const std::uint8_t byte = 0;
    take("positions", b.positions, {n_agents, 2}, std::int32_t{});
    take("alive", b.alive, {n_agents}, bool{});
    take("captured", b.captured, {n_evaders}, bool{});
    take("ever_captured", b.ever_captured, {n_evaders}, bool{});
    take("captors", b.captors, {n_evaders}, std::int32_t{});
    take("involved", b.involved, {n_agents, kKinds}, bool{});
    take("fault", b.fault, {n_agents, kKinds}, bool{});
    take("rewards", b.rewards, {n_agents}, float{});
    take("steps", b.steps, {}, std::int32_t{});
    take("terminated", b.terminated, {}, bool{});
    take("truncated", b.truncated, {}, bool{});
    take("views", b.views, {n_agents, kChannels, config.fov, config.fov}, byte);
    take("state", b.state, {kChannels, config.rows, config.cols}, byte);
    if (known != arrays.size()) {
        throw py::value_error(
            "buffers: expected some of positions, alive, captured, ever_captured, captors, "
            "involved, fault, rewards, steps, terminated, truncated, views, state, got " +
            py::str(py::list(arrays)).cast<std::string>());
    }
    return held;
}

// Calls use(pointer) with the integers of an array of this shape.
template <typename Use>
void with_integers(const std::string& name, const py::array& given, const Shape& shape, Use use) {
    require_shape(name, given, shape);
    const py::array array = py::array::ensure(given, py::array::c_style);
    const auto is = [&](auto integer) {
        return array.dtype().is(py::dtype::of<decltype(integer)>());
    };
    if (is(std::uint8_t{})) return use(static_cast<const std::uint8_t*>(array.data()));
    if (is(std::int8_t{})) return use(static_cast<const std::int8_t*>(array.data()));
    if (is(std::int32_t{})) return use(static_cast<const std::int32_t*>(array.data()));
    if (is(std::int64_t{})) return use(static_cast<const std::int64_t*>(array.data()));
    throw py::type_error(name + ": expected dtype uint8, int8, int32 or int64, got " +
                         py::str(array.dtype()).cast<std::string>());
}

// ---- One world --------------------------------------------------------------------------------------

std::vector<int> to_positions(const py::object& positions) {
    if (positions.is_none()) return {};
    const auto array = positions.cast<Array<int>>();
    return std::vector<int>(array.data(), array.data() + array.size());
}

class SingleWorld {
  public:
    explicit SingleWorld(std::shared_ptr<const Setup> setup)
        : setup_(std::move(setup)), world_(setup_), scratch_(*setup_) {}

    void reset(std::uint64_t seed, std::uint64_t episode, const py::object& pursuers,
               const py::object& evaders, const py::object& map) {
        const Placement placement{to_positions(pursuers), to_positions(evaders), to_map(map)};
        World fresh(setup_);
        world_.leave(scratch_);
        try {
            fresh.reset({seed, episode}, scratch_, placement);
        } catch (...) {
            world_.enter(scratch_);
            throw;
        }
        world_ = std::move(fresh);
        conflicts_.clear();
    }

    void step(const py::array& actions, bool explain) {
        std::vector<std::uint8_t> committed(setup_->config.n_agents(), 0);
        with_integers("actions", actions, {setup_->config.n_agents()}, [&](const auto* given) {
            commit_actions(world_, 0, given, committed.data());
        });
        conflicts_.clear();
        world_.step(committed.data(), scratch_, explain ? &conflicts_ : nullptr);
    }

    void write(const py::dict& arrays) const {
        const HeldBuffers held = hold(setup_->config, {}, arrays);
        matrixworld::write(world_, scratch_.occupancy, 0, held.pointers);
    }

    // (turn, kind, form, first, second, (row, col), at_fault, held, doomed)
    py::list conflicts() const {
        py::list list;
        for (const Conflict& c : conflicts_) {
            const int row = world_.grid().row(c.cell);
            const int col = world_.grid().col(c.cell);
            list.append(py::make_tuple(c.turn, static_cast<int>(c.kind), static_cast<int>(c.form),
                                       c.first, c.second, py::make_tuple(row, col), c.at_fault,
                                       c.held, c.doomed));
        }
        return list;
    }

    py::array_t<float> logits(const Network& network, const Array<float>& genome) const {
        Mlp mlp(network, setup_->grid);
        mlp.load(genome.data());
        std::vector<std::uint8_t> actions;
        const std::vector<float> units(world_.living().size(), 0.0f);
        mlp.act(world_, scratch_.occupancy, world_.living(), units, actions);
        const auto n = static_cast<py::ssize_t>(world_.living().size());
        py::array_t<float> out({n, static_cast<py::ssize_t>(network.n_actions())});
        const int width = padded(network.n_actions());
        for (py::ssize_t i = 0; i < n; ++i) {
            std::copy_n(mlp.logits() + i * width, network.n_actions(), out.mutable_data(i, 0));
        }
        return out;
    }

  private:
    std::shared_ptr<const Setup> setup_;
    World world_;
    Scratch scratch_;
    std::vector<Conflict> conflicts_;
};

// ---- Batch ------------------------------------------------------------------------------------------

class BufferedBatch {
  public:
    BufferedBatch(const std::shared_ptr<const Setup>& setup, int n_worlds, int n_threads,
                  bool autoreset, const py::dict& buffers)
        : buffers_(hold(setup->config, {n_worlds}, buffers)),
          batch_(setup, n_worlds, n_threads, autoreset) {}

    void reset(const Array<std::uint64_t>& seeds, std::uint64_t episode) {
        require_shape("seeds", seeds, {batch_.n_worlds()});
        const py::gil_scoped_release release;
        batch_.reset(seeds.data(), episode, buffers_.pointers);
    }

    void step(const py::array& actions) {
        const Shape shape{batch_.n_worlds(), batch_.setup().config.n_agents()};
        with_integers("actions", actions, shape, [&](const auto* given) {
            const py::gil_scoped_release release;
            batch_.step(given, buffers_.pointers);
        });
    }

  private:
    HeldBuffers buffers_;
    Batch batch_;
};

// ---- Rollouts ---------------------------------------------------------------------------------------

const std::map<std::string, Script>& scripts() {
    static const std::map<std::string, Script> by_name = {{"random", Script::Random},
                                                          {"still", Script::Still},
                                                          {"chaser", Script::Chaser},
                                                          {"fleer", Script::Fleer}};
    return by_name;
}

Network make_network(int fov, const std::vector<int>& hidden, int n_actions,
                     const std::string& activation, bool sampled) {
    if (activation != "relu" && activation != "tanh") {
        throw py::value_error("activation: expected 'relu' or 'tanh', got '" + activation + "'");
    }
    return Network(fov, hidden, n_actions,
                   activation == "relu" ? Activation::Relu : Activation::Tanh, sampled);
}

// A script's name, or (Network, genomes (n, genome_size) float32).
struct HeldCandidates {
    Candidates candidates;
    Array<float> genomes;
};

HeldCandidates to_candidates(const char* team, const py::object& given, const Config& config) {
    HeldCandidates held;
    if (py::isinstance<py::str>(given)) {
        const auto name = given.cast<std::string>();
        if (!scripts().count(name)) {
            throw py::value_error(std::string(team) +
                                  ": expected random, still, chaser or fleer, got '" + name + "'");
        }
        held.candidates.script = scripts().at(name);
        return held;
    }
    const auto pair = given.cast<std::pair<Network, Array<float>>>();
    const Network& network = pair.first;
    held.genomes = pair.second;
    if (network.fov != config.fov || network.n_actions() != config.n_actions()) {
        throw py::value_error(std::string(team) + ": expected a network for fov " +
                              std::to_string(config.fov) + " and " +
                              std::to_string(config.n_actions()) + " actions, got fov " +
                              std::to_string(network.fov) + " and " +
                              std::to_string(network.n_actions()) + " actions");
    }
    const py::ssize_t n = held.genomes.ndim() > 0 ? held.genomes.shape(0) : 0;
    require_shape(std::string(team) + " genomes", held.genomes, {n, network.genome_size()});
    held.candidates.network = network;
    held.candidates.genomes = held.genomes.data();
    held.candidates.n = static_cast<int>(n);
    return held;
}

void require_index(const char* name, std::int32_t index, int n) {
    if (index >= 0 && index < n) return;
    throw py::value_error(std::string(name) + ": expected 0 to " + std::to_string(n - 1) +
                          ", got " + std::to_string(index));
}

template <typename T, typename Get>
py::array_t<T> column(const std::vector<Score>& scores, Shape shape, const Shape& rest, Get get) {
    py::ssize_t per_score = 1;
    for (py::ssize_t size : rest) per_score *= size;
    shape.insert(shape.end(), rest.begin(), rest.end());
    py::array_t<T> array(shape);
    T* out = array.mutable_data();
    for (const Score& score : scores) {
        const T* from = get(score);
        out = std::copy_n(from, per_score, out);
    }
    return array;
}

py::dict to_columns(const std::vector<Score>& scores, const Shape& shape) {
    py::dict out;
    const Shape by_kind{kTeams, kKinds};
    const auto put = [&](const char* name, auto get, const Shape& rest = {}) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(get(scores[0]))>>;
        out[name] = column<T>(scores, shape, rest, get);
    };
    put("capture_rate", [](const Score& s) { return &s.capture_rate; });
    put("captured_fraction", [](const Score& s) { return &s.captured_fraction; });
    put("length", [](const Score& s) { return &s.length; });
    put("pursuer_return", [](const Score& s) { return &s.returns[0]; });
    put("evader_return", [](const Score& s) { return &s.returns[1]; });
    put("pursuer_survivors", [](const Score& s) { return &s.survivors[0]; });
    put("evader_survivors", [](const Score& s) { return &s.survivors[1]; });
    put("pursuer_crowding", [](const Score& s) { return &s.crowding[0]; });
    put("evader_crowding", [](const Score& s) { return &s.crowding[1]; });
    put("collisions", [](const Score& s) { return s.collisions.data(); }, by_kind);
    put("faults", [](const Score& s) { return s.faults.data(); }, by_kind);
    return out;
}

py::dict rollout(const std::shared_ptr<const Setup>& setup, const py::object& pursuers,
                 const py::object& evaders, const Array<std::int32_t>& pursuer,
                 const Array<std::int32_t>& evader, const Array<std::uint64_t>& seed, int n_worlds,
                 int n_threads) {
    const HeldCandidates left = to_candidates("pursuers", pursuers, setup->config);
    const HeldCandidates right = to_candidates("evaders", evaders, setup->config);
    const py::ssize_t n = seed.size();
    require_shape("pursuer", pursuer, {n});
    require_shape("evader", evader, {n});
    require_shape("seed", seed, {n});
    std::vector<Match> matches;
    for (py::ssize_t i = 0; i < n; ++i) {
        require_index("pursuer", pursuer.at(i), left.candidates.n);
        require_index("evader", evader.at(i), right.candidates.n);
        matches.push_back({pursuer.at(i), evader.at(i), seed.at(i)});
    }
    std::vector<Score> scores;
    {
        const py::gil_scoped_release release;
        scores =
            play_matches(setup, left.candidates, right.candidates, matches, n_worlds, n_threads);
    }
    return to_columns(scores, {n, n_worlds});
}

// An episode's arrays, grown step by step.
class Recorder {
  public:
    explicit Recorder(const Config& config) : config_(config) {}

    void see(const World& world, const std::vector<std::uint8_t>* actions) {
        const std::size_t n_agents = config_.n_agents();
        const std::size_t n_evaders = config_.n_evaders;
        grow(positions_, 2 * n_agents);
        grow(alive_, n_agents);
        grow(captured_, n_evaders);
        grow(ever_captured_, n_evaders);
        for (std::size_t a = 0; a < n_agents; ++a) {
            const int agent = static_cast<int>(a);
            const bool alive = world.alive(agent);
            const std::size_t at = moments_ * n_agents + a;
            positions_[2 * at] = alive ? world.grid().row(world.cell(agent)) : kGone;
            positions_[2 * at + 1] = alive ? world.grid().col(world.cell(agent)) : kGone;
            alive_[at] = alive;
        }
        std::copy_n(world.captured().data(), n_evaders, &captured_[moments_ * n_evaders]);
        std::copy_n(world.ever_captured().data(), n_evaders, &ever_captured_[moments_ * n_evaders]);
        if (actions) see_step(world, *actions);
        ++moments_;
    }

    py::dict arrays() const {
        const auto t = static_cast<py::ssize_t>(moments_);
        const py::ssize_t n_agents = config_.n_agents();
        const py::ssize_t n_evaders = config_.n_evaders;
        py::dict out;
        out["positions"] = to_array(positions_, {t, n_agents, 2});
        out["alive"] = to_array(alive_, {t, n_agents});
        out["captured"] = to_array(captured_, {t, n_evaders});
        out["ever_captured"] = to_array(ever_captured_, {t, n_evaders});
        out["actions"] = to_array(actions_, {t - 1, n_agents});
        out["rewards"] = to_array(rewards_, {t - 1, n_agents});
        out["involved"] = to_array(involved_, {t - 1, n_agents, kKinds});
        out["fault"] = to_array(fault_, {t - 1, n_agents, kKinds});
        return out;
    }

  private:
    void see_step(const World& world, const std::vector<std::uint8_t>& actions) {
        for (std::size_t a = 0; a < actions.size(); ++a) {
            const int agent = static_cast<int>(a);
            const Flags report = world.report(agent);
            actions_.push_back(static_cast<std::int8_t>(actions[a]));
            rewards_.push_back(world.rewards()[agent]);
            for (int kind = 0; kind < kKinds; ++kind) {
                involved_.push_back(report >> kind & 1);
                fault_.push_back(report >> (kKinds + kind) & 1);
            }
        }
    }

    template <typename T>
    static void grow(std::vector<T>& values, std::size_t by) {
        values.resize(values.size() + by);
    }

    template <typename T>
    static py::array_t<T> to_array(const std::vector<T>& values, const Shape& shape) {
        py::array_t<T> array(shape);
        std::copy(values.begin(), values.end(), array.mutable_data());
        return array;
    }

    const Config& config_;
    std::size_t moments_ = 0;
    std::vector<std::int32_t> positions_;
    std::vector<std::uint8_t> alive_, captured_, ever_captured_, involved_, fault_;
    std::vector<std::int8_t> actions_;
    std::vector<float> rewards_;
};

py::array_t<std::uint8_t> map_of(const World& world) {
    const Config& config = world.config();
    py::array_t<std::uint8_t> map({config.rows, config.cols});
    for (int row = 0; row < config.rows; ++row) {
        for (int col = 0; col < config.cols; ++col) {
            const int cell = world.grid().cell(row, col);
            map.mutable_at(row, col) = world.ground().kind[cell] == kObstacle;
        }
    }
    return map;
}

py::dict record(const std::shared_ptr<const Setup>& setup, const py::object& pursuers,
                const py::object& evaders, int pursuer, int evader, std::uint64_t seed,
                std::uint64_t episode) {
    const HeldCandidates left = to_candidates("pursuers", pursuers, setup->config);
    const HeldCandidates right = to_candidates("evaders", evaders, setup->config);
    require_index("pursuer", pursuer, left.candidates.n);
    require_index("evader", evader, right.candidates.n);
    Recorder recorder(setup->config);
    py::object map;
    watch_match(setup, left.candidates, right.candidates, {pursuer, evader, seed}, episode,
                [&](const World& world, const std::vector<std::uint8_t>* actions) {
                    if (!actions) map = map_of(world);
                    recorder.see(world, actions);
                });
    py::dict out = recorder.arrays();
    out["map"] = map;
    return out;
}

std::array<std::uint64_t, 4> philox_block(std::array<std::uint64_t, 4> counter,
                                          std::array<std::uint64_t, 2> key) {
    return philox(counter, key[0], key[1]);
}

}  // namespace

PYBIND11_MODULE(_core, m) {
    m.doc() = "The engine of matrixworld. Use it through the package.";

    py::native_enum<Outcome>(m, "Outcome", "enum.Enum", "What a collision does to an agent.")
        .value("DISAPPEAR", Outcome::Disappear)
        .value("REACH", Outcome::Reach)
        .value("BOUNCE", Outcome::Bounce)
        .finalize();
    py::native_enum<Interaction>(m, "Interaction", "enum.Enum", "Who moves together.")
        .value("SIMULTANEOUS", Interaction::Simultaneous)
        .value("SWARM_TURNS", Interaction::SwarmTurns)
        .value("AGENT_TURNS", Interaction::AgentTurns)
        .finalize();
    py::native_enum<Capture>(m, "Capture", "enum.Enum", "How an evader is captured.")
        .value("OCCUPATION", Capture::Occupation)
        .value("SURROUND", Capture::Surround)
        .finalize();

    py::class_<Rules>(m, "Rules")
        .def(py::init<Interaction, Outcome, Outcome, Outcome, Outcome, Capture, bool>(),
             py::kw_only(), py::arg("interaction"), py::arg("obstacle"), py::arg("teammate"),
             py::arg("evader"), py::arg("pursuer"), py::arg("capture"),
             py::arg("captured_disappear"));
    py::class_<Rewards>(m, "Rewards")
        .def(py::init(&make_rewards), py::kw_only(), py::arg("capture"), py::arg("neighbor"),
             py::arg("collide"), py::arg("step"), py::arg("capture_repeats"));
    py::class_<Setup, std::shared_ptr<Setup>>(m, "Setup")
        .def(py::init([](const Rules& rules, const Rewards& rewards, int rows, int cols,
                         int n_pursuers, int n_evaders, int fov, bool diagonal, int max_steps,
                         double density, const py::object& map) {
                 return std::const_pointer_cast<Setup>(
                     make_setup(rules, rewards, rows, cols, n_pursuers, n_evaders, fov, diagonal,
                                max_steps, density, map));
             }),
             py::kw_only(), py::arg("rules"), py::arg("rewards"), py::arg("rows"), py::arg("cols"),
             py::arg("n_pursuers"), py::arg("n_evaders"), py::arg("fov"), py::arg("diagonal"),
             py::arg("max_steps"), py::arg("density"), py::arg("map"));

    py::class_<Network>(m, "Network")
        .def(py::init(&make_network), py::kw_only(), py::arg("fov"), py::arg("hidden"),
             py::arg("n_actions"), py::arg("activation"), py::arg("sampled"));

    py::class_<SingleWorld>(m, "World")
        .def(py::init<std::shared_ptr<const Setup>>(), py::arg("setup"))
        .def("reset", &SingleWorld::reset, py::arg("seed"), py::arg("episode"), py::arg("pursuers"),
             py::arg("evaders"), py::arg("map"))
        .def("step", &SingleWorld::step, py::arg("actions"), py::arg("explain"))
        .def("write", &SingleWorld::write, py::arg("arrays"))
        .def("conflicts", &SingleWorld::conflicts)
        .def("logits", &SingleWorld::logits, py::arg("network"), py::arg("genome"));

    py::class_<BufferedBatch>(m, "Batch")
        .def(py::init<const std::shared_ptr<const Setup>&, int, int, bool, const py::dict&>(),
             py::arg("setup"), py::arg("n_worlds"), py::arg("n_threads"), py::arg("autoreset"),
             py::arg("buffers"))
        .def("reset", &BufferedBatch::reset, py::arg("seeds").noconvert(), py::arg("episode"))
        .def("step", &BufferedBatch::step, py::arg("actions"));

    m.def("rollout", &rollout, py::arg("setup"), py::arg("pursuers"), py::arg("evaders"),
          py::arg("pursuer").noconvert(), py::arg("evader").noconvert(),
          py::arg("seed").noconvert(), py::arg("n_worlds"), py::arg("n_threads"));
    m.def("record", &record, py::arg("setup"), py::arg("pursuers"), py::arg("evaders"),
          py::arg("pursuer"), py::arg("evader"), py::arg("seed"), py::arg("episode"));
    m.def("philox", &philox_block, py::arg("counter"), py::arg("key"));
    m.def("kernel_level", [] { return kernels().level; });
}
