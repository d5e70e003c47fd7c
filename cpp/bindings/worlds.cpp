// One world, and batches of them, for Python.
#include <pybind11/stl.h>

#include <string>
#include <type_traits>

#include "bindings/bindings.hpp"
#include "bindings/candidates.hpp"
#include "bindings/in_use.hpp"
#include "bindings/locked.hpp"
#include "bindings/numpy_arrays.hpp"
#include "bindings/numpy_buffers.hpp"
#include "play/batch.hpp"
#include "play/mlp.hpp"

namespace matrixworld {

namespace {

// ---- One world --------------------------------------------------------------------------------

std::vector<int> to_positions(const py::object& positions) {
    if (positions.is_none()) return {};
    const auto array = positions.cast<Array<int>>();
    return std::vector<int>(array.data(), array.data() + array.size());
}

// One field of a snapshot for Python: a number, or an array for a list of numbers.
template <typename Value>
py::object to_python(const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
        return py::cast(value);
    } else {
        return py::array_t<typename Value::value_type>(value.size(), value.data());
    }
}

template <typename Value>
void from_python(const py::object& given, Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
        value = given.cast<Value>();
    } else {
        const auto array = given.cast<Array<typename Value::value_type>>();
        value.resize(array.size());
        std::copy_n(array.data(), array.size(), value.data());
    }
}

py::dict to_dict(const Snapshot& snapshot, const Config& config, int turn) {
    py::dict out;
    out["turn"] = turn;
    for_each_field(snapshot, config, [&](const SnapshotField& field, const auto& value) {
        out[field.name] = to_python(value);
    });
    return out;
}

py::object entry(const py::dict& from, const char* name) {
    if (from.contains(name)) return from[name];
    throw py::value_error("snapshot, " + std::string(name) + ": expected an entry, got none");
}

Snapshot to_snapshot(const py::dict& from, const Config& config) {
    Snapshot snapshot;
    for_each_field(snapshot, config, [&](const SnapshotField& field, auto& value) {
        from_python(entry(from, field.name), value);
    });
    return snapshot;
}

// A world with a scratch of its own, in which its agents stay between two calls. No method releases
// the GIL, or calls what may release it, between two accesses to the world.
class SingleWorld {
  public:
    explicit SingleWorld(std::shared_ptr<const Setup> setup)
        : setup_(std::move(setup)), world_(setup_), scratch_(*setup_), observer_(*setup_) {
        source_.observer = &observer_;
    }

    // `source_` points to this object's own observer.
    SingleWorld(const SingleWorld&) = delete;
    SingleWorld& operator=(const SingleWorld&) = delete;

    void reset(std::uint64_t seed, std::uint64_t episode, const py::object& pursuers,
               const py::object& evaders, const py::object& map) {
        const Placement placement{to_positions(pursuers), to_positions(evaders), to_map(map)};
        become([&](World& fresh) { fresh.reset({seed, episode}, scratch_, placement); });
        turn_ = 0;
        conflicts_.clear();
    }

    void step(const py::array& actions, bool explain) {
        const std::vector<std::uint8_t> committed = commit(actions, false);
        conflicts_.clear();
        world_.step(committed.data(), scratch_, explain ? &conflicts_ : nullptr);
    }

    // The next turn of the round.
    void play_turn(const py::array& actions, bool explain) {
        const std::vector<std::uint8_t> committed = commit(actions, true);
        if (turn_ == 0) {
            conflicts_.clear();
            world_.begin_round();
        }
        world_.play_turn(turn_, committed.data(), scratch_, explain ? &conflicts_ : nullptr);
        if (++turn_ < world_.n_turns()) return;
        world_.end_round();
        turn_ = 0;
    }

    // Writes the actions that a policy chooses now for living agents of one team.
    void decide(const py::object& policy, int first, int last, const py::array& actions) {
        const Config& config = setup_->config;
        const HeldCandidates held = to_policy("policy", policy, config);
        require_agents(first, last, config);
        std::int64_t* const out = writeable_actions(actions, {config.n_agents()});
        if (world_.over()) return;
        LoadedPolicy loaded(held.candidates, *setup_);
        loaded.load(0).decide(world_, scratch_.occupancy, first, last, out);
    }

    int turn() const { return turn_; }
    int n_turns() const { return world_.n_turns(); }
    std::pair<int, int> actors() const {
        int first = 0;
        int last = 0;
        world_.actors(turn_, first, last);
        return {first, last};
    }

    py::dict snapshot() const { return to_dict(world_.snapshot(scratch_), setup_->config, turn_); }

    void restore(const py::dict& from) {
        const Snapshot s = to_snapshot(from, setup_->config);
        const int turn = entry(from, "turn").cast<int>();
        if (turn < 0 || turn >= world_.n_turns()) {
            throw py::value_error("snapshot, turn: expected 0 to " +
                                  std::to_string(world_.n_turns() - 1) + ", got " +
                                  std::to_string(turn));
        }
        become([&](World& fresh) { fresh.restore(s, scratch_); });
        turn_ = turn;
    }

    // Fills the caller's arrays with world fields.
    void write(const py::dict& arrays) {
        const HeldBuffers held = hold_world(setup_->config, arrays);
        source_.look_at(world_, scratch_.occupancy);
        held.buffers.write(Written::Step, source_, 0);
        held.buffers.write(Written::Moment, source_, 0);
    }

    // (turn, kind, form, first, second, (row, col), at_fault, held, doomed)
    py::list conflicts() const {
        const std::vector<Conflict> conflicts = conflicts_;  // new tuples may start Python's GC
        py::list list;
        for (const Conflict& c : conflicts) {
            const int row = world_.grid().row(c.cell);
            const int col = world_.grid().col(c.cell);
            list.append(py::make_tuple(c.turn, static_cast<int>(c.kind), static_cast<int>(c.form),
                                       c.first, c.second, py::make_tuple(row, col), c.at_fault,
                                       c.held, c.doomed));
        }
        return list;
    }

    // For tests of the network: its outputs for the living agents, without choosing actions.
    py::array_t<float> logits(const Network& network, const Array<float>& genome) const {
        if (network.fov != setup_->config.fov) {
            throw py::value_error("network: expected fov " + std::to_string(setup_->config.fov) +
                                  ", got " + std::to_string(network.fov));
        }
        require_shape("genome", genome, {network.genome_size()});
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
    // The actions of all agents, or of those that act in the next turn.
    std::vector<std::uint8_t> commit(const py::array& actions, bool of_turn) const {
        const int n_agents = setup_->config.n_agents();
        std::vector<std::uint8_t> committed(static_cast<std::size_t>(n_agents), 0);
        with_integers("actions", actions, {n_agents}, [&](const auto* given) {
            const auto [first, last] = of_turn ? actors() : std::pair{0, n_agents};
            commit_actions(world_, 0, first, last, given, committed.data());
        });
        return committed;
    }

    // Replaces this world by a fresh one on which `begin` was called. If `begin` throws, this world
    // stays as it was: it leaves the scratch only for as long as the fresh one may need it.
    template <typename Begin>
    void become(Begin begin) {
        World fresh(setup_);
        world_.leave(scratch_);
        try {
            begin(fresh);
        } catch (...) {
            world_.enter(scratch_);
            throw;
        }
        world_ = std::move(fresh);
    }

    std::shared_ptr<const Setup> setup_;
    World world_;
    Scratch scratch_;
    Observer observer_;
    OutputSource source_;
    int turn_ = 0;  // the next one of the round
    std::vector<Conflict> conflicts_;
};

// ---- Batch ------------------------------------------------------------------------------------

// Positions (W, n, 2) or None for each team; one map for all worlds, or None.
std::vector<Placement> to_placements(const py::object& pursuers, const py::object& evaders,
                                     const py::object& map, int n_worlds) {
    if (pursuers.is_none() && evaders.is_none() && map.is_none()) return {};
    std::vector<Placement> placements(static_cast<std::size_t>(n_worlds));
    const auto deal = [&](const py::object& given, std::vector<int> Placement::* share) {
        const std::vector<int> all = to_positions(given);
        const std::size_t size = all.size() / placements.size();
        for (std::size_t w = 0; w < placements.size(); ++w) {
            (placements[w].*share).assign(all.begin() + w * size, all.begin() + (w + 1) * size);
        }
    };
    deal(pursuers, &Placement::pursuers);
    deal(evaders, &Placement::evaders);
    const ByteArray terrain = to_map(map);
    for (Placement& placement : placements) placement.map = terrain;
    return placements;
}

// A batch with the caller's arrays. Steps and resets run without the GIL, after all checks that need
// Python objects. Other threads may write to the arguments meanwhile, so what decides about memory
// is copied, and the copy is checked.
class BufferedBatch {
  public:
    BufferedBatch(const std::shared_ptr<const Setup>& setup, int n_worlds, int n_threads,
                  Autoreset autoreset, const py::dict& buffers)
        : held_(hold_batch(setup->config, n_worlds, buffers)),
          batch_(setup, n_worlds, n_threads, autoreset) {}

    void reset(const std::optional<Array<std::uint64_t>>& seeds, std::uint64_t episode,
               const std::optional<Array<bool>>& mask, const py::object& pursuers,
               const py::object& evaders, const py::object& map) {
        const InUse::Call call(in_use_);
        const int n = batch_.n_worlds();
        if (seeds) require_shape("seeds", *seeds, {n});
        if (mask) require_shape("mask", *mask, {n});
        const std::vector<Placement> placements = to_placements(pursuers, evaders, map, n);
        const std::uint64_t* first_seed = seeds ? seeds->data() : nullptr;
        std::vector<std::uint8_t> chosen;
        if (mask) chosen.assign(mask->data(), mask->data() + n);
        const py::gil_scoped_release release;
        batch_.reset(first_seed, episode, mask ? chosen.data() : nullptr, placements,
                     held_.buffers);
    }

    void step(const py::array& actions) {
        const InUse::Call call(in_use_);
        const Shape shape{batch_.n_worlds(), batch_.setup().config.n_agents()};
        with_integers("actions", actions, shape, [&](const auto* given) {
            const py::gil_scoped_release release;
            batch_.step(given, held_.buffers);
        });
    }

    // The next turn of the round.
    void play_turn(const py::array& actions) {
        const InUse::Call call(in_use_);
        const Shape shape{batch_.n_worlds(), batch_.setup().config.n_agents()};
        with_integers("actions", actions, shape, [&](const auto* given) {
            const py::gil_scoped_release release;
            batch_.play_turn(given, held_.buffers);
        });
    }

    int turn() const { return batch_.turn(); }
    int n_turns() const { return batch_.n_turns(); }
    std::pair<int, int> actors() const { return batch_.actors(); }

    // Policies are candidates of one genome, or None where something else decides.
    void decide(const py::list& policies, const Array<std::int32_t>& chosen, int first, int last,
                const py::array& actions) {
        const InUse::Call call(in_use_);
        const Config& config = batch_.setup().config;
        const int n = batch_.n_worlds();
        std::vector<HeldCandidates> held;
        std::vector<Candidates> candidates;
        for (const py::handle given : policies) {
            const auto policy = py::reinterpret_borrow<py::object>(given);
            held.push_back(policy.is_none() ? HeldCandidates{}
                                            : to_policy("policies", policy, config));
            candidates.push_back(held.back().candidates);
        }
        require_shape("chosen", chosen, {n});
        const std::vector<std::int32_t> numbers(chosen.data(), chosen.data() + n);
        for (const std::int32_t number : numbers) {
            require_index("chosen", number, static_cast<int>(candidates.size()));
        }
        require_agents(first, last, config);
        std::int64_t* const out = writeable_actions(actions, {n, config.n_agents()});
        const py::gil_scoped_release release;
        batch_.decide(candidates, numbers, first, last, out);
    }

    py::dict snapshot(int w) {
        const InUse::Call call(in_use_);
        return to_dict(batch_.snapshot(w), batch_.setup().config, batch_.turn());
    }

  private:
    InUse in_use_;
    HeldBuffers held_;
    Batch batch_;
};

}  // namespace

void bind_worlds(py::module_& m) {
    py::class_<SingleWorld>(m, "World")
        .def(py::init<std::shared_ptr<const Setup>>(), py::arg("setup"))
        .def("reset", locked(&SingleWorld::reset), py::arg("seed"), py::arg("episode"),
             py::arg("pursuers"), py::arg("evaders"), py::arg("map"))
        .def("step", locked(&SingleWorld::step), py::arg("actions"), py::arg("explain"))
        .def("play_turn", locked(&SingleWorld::play_turn), py::arg("actions"), py::arg("explain"))
        .def("decide", locked(&SingleWorld::decide), py::arg("policy"), py::arg("first"),
             py::arg("last"), py::arg("actions"))
        .def("turn", locked(&SingleWorld::turn))
        .def("n_turns", locked(&SingleWorld::n_turns))
        .def("actors", locked(&SingleWorld::actors))
        .def("write", locked(&SingleWorld::write), py::arg("arrays"))
        .def("conflicts", locked(&SingleWorld::conflicts))
        .def("snapshot", locked(&SingleWorld::snapshot))
        .def("restore", locked(&SingleWorld::restore), py::arg("snapshot"))
        .def("logits", locked(&SingleWorld::logits), py::arg("network"), py::arg("genome"));

    py::class_<BufferedBatch>(m, "Batch")
        .def(py::init<const std::shared_ptr<const Setup>&, int, int, Autoreset, const py::dict&>(),
             py::arg("setup"), py::arg("n_worlds"), py::arg("n_threads"), py::arg("autoreset"),
             py::arg("buffers"))
        .def("reset", &BufferedBatch::reset, py::arg("seeds"), py::arg("episode"), py::arg("mask"),
             py::arg("pursuers"), py::arg("evaders"), py::arg("map"))
        .def("step", &BufferedBatch::step, py::arg("actions"))
        .def("play_turn", &BufferedBatch::play_turn, py::arg("actions"))
        .def("turn", &BufferedBatch::turn)
        .def("n_turns", &BufferedBatch::n_turns)
        .def("actors", &BufferedBatch::actors)
        .def("decide", &BufferedBatch::decide, py::arg("policies"), py::arg("chosen").noconvert(),
             py::arg("first"), py::arg("last"), py::arg("actions"))
        .def("snapshot", &BufferedBatch::snapshot, py::arg("world"));
}

}  // namespace matrixworld
