// Networks, rollouts and recordings for Python.
#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "bindings/bindings.hpp"
#include "bindings/numpy_arrays.hpp"
#include "play/rollout.hpp"

namespace matrixworld {

namespace {

std::string script_names() {
    std::string names;
    for (const Script& script : scripts())
        names += (names.empty() ? "" : ", ") + std::string(script.name);
    return names;
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
        held.candidates.script = find_script(name);
        if (!held.candidates.script) {
            throw py::value_error(std::string(team) + ": expected one of " + script_names() +
                                  ", got '" + name + "'");
        }
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
py::array_t<T> column(const std::vector<EpisodeStatistics>& scores, Shape shape, const Shape& rest,
                      Get get) {
    py::ssize_t per_score = 1;
    for (py::ssize_t size : rest) per_score *= size;
    shape.insert(shape.end(), rest.begin(), rest.end());
    py::array_t<T> array(shape);
    T* out = array.mutable_data();
    for (const EpisodeStatistics& score : scores) {
        const T* from = get(score);
        out = std::copy_n(from, per_score, out);
    }
    return array;
}

py::dict to_columns(const std::vector<EpisodeStatistics>& scores, const Shape& shape) {
    py::dict out;
    const Shape by_kind{kTeams, kKinds};
    const auto put = [&](const char* name, auto get, const Shape& rest = {}) {
        using T = std::remove_cv_t<std::remove_pointer_t<decltype(get(scores[0]))>>;
        out[name] = column<T>(scores, shape, rest, get);
    };
    put("capture_rate", [](const EpisodeStatistics& s) { return &s.capture_rate; });
    put("ever_capture_rate", [](const EpisodeStatistics& s) { return &s.ever_capture_rate; });
    put("captured_fraction", [](const EpisodeStatistics& s) { return &s.captured_fraction; });
    put("length", [](const EpisodeStatistics& s) { return &s.length; });
    put("pursuer_return", [](const EpisodeStatistics& s) { return &s.returns[0]; });
    put("evader_return", [](const EpisodeStatistics& s) { return &s.returns[1]; });
    put("pursuer_survivors", [](const EpisodeStatistics& s) { return &s.survivors[0]; });
    put("evader_survivors", [](const EpisodeStatistics& s) { return &s.survivors[1]; });
    put("pursuer_overlap", [](const EpisodeStatistics& s) { return &s.overlap[0]; });
    put("evader_overlap", [](const EpisodeStatistics& s) { return &s.overlap[1]; });
    put("collisions", [](const EpisodeStatistics& s) { return s.collisions.data(); }, by_kind);
    put("faults", [](const EpisodeStatistics& s) { return s.faults.data(); }, by_kind);
    put("agent_steps", [](const EpisodeStatistics& s) { return s.agent_steps.data(); }, {kTeams});
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
    std::vector<EpisodeStatistics> scores;
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
        grow(last_positions_, 2 * n_agents);
        grow(alive_, n_agents);
        grow(captured_, n_evaders);
        grow(ever_captured_, n_evaders);
        for (std::size_t a = 0; a < n_agents; ++a) {
            const int agent = static_cast<int>(a);
            const bool alive = world.alive(agent);
            const std::size_t at = moments_ * n_agents + a;
            const int cell = world.alive(agent) ? world.cell(agent) : world.last_cells()[agent];
            last_positions_[2 * at] = world.grid().row(cell);
            last_positions_[2 * at + 1] = world.grid().col(cell);
            positions_[2 * at] = alive ? last_positions_[2 * at] : kGone;
            positions_[2 * at + 1] = alive ? last_positions_[2 * at + 1] : kGone;
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
        out["last_positions"] = to_array(last_positions_, {t, n_agents, 2});
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
    std::vector<std::int32_t> positions_, last_positions_;
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
            map.mutable_at(row, col) = world.terrain().kind[cell] == kObstacle;
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

}  // namespace

void bind_rollouts(py::module_& m) {
    py::class_<Network>(m, "Network")
        .def(py::init(&make_network), py::kw_only(), py::arg("fov"), py::arg("hidden"),
             py::arg("n_actions"), py::arg("activation"), py::arg("sampled"));
    m.def("rollout", &rollout, py::arg("setup"), py::arg("pursuers"), py::arg("evaders"),
          py::arg("pursuer").noconvert(), py::arg("evader").noconvert(),
          py::arg("seed").noconvert(), py::arg("n_worlds"), py::arg("n_threads"));
    m.def("record", &record, py::arg("setup"), py::arg("pursuers"), py::arg("evaders"),
          py::arg("pursuer"), py::arg("evader"), py::arg("seed"), py::arg("episode"));
}

}  // namespace matrixworld
