#include "bindings/candidates.hpp"

#include <utility>

#include "solve/table_policy.hpp"

namespace matrixworld {

namespace {

std::string script_names() {
    std::string names;
    for (const Script& script : scripts()) names += (names.empty() ? "" : ", ") + script.name;
    return names;
}

}  // namespace

HeldCandidates to_candidates(const std::string& name, const py::object& given,
                             const Config& config) {
    HeldCandidates held;
    if (py::isinstance<py::str>(given)) {
        const auto script = given.cast<std::string>();
        held.candidates.script = find_script(script);
        if (!held.candidates.script) {
            throw py::value_error(name + ": expected one of " + script_names() + ", got '" +
                                  script + "'");
        }
        require_sight(name, *held.candidates.script, config);
        return held;
    }
    if (py::isinstance<Tables>(given)) {
        const auto tables = given.cast<std::shared_ptr<Tables>>();
        tables->check(config);
        held.candidates.make = [tables] { return std::make_unique<TablePolicy>(tables); };
        return held;
    }
    const auto [shape, genomes] = given.cast<std::pair<py::object, Array<float>>>();
    held.genomes = genomes;
    held.candidates.genomes = genomes.data();
    // The number of genomes is free, the rest of the shape is not.
    const py::ssize_t n = genomes.ndim() > 0 ? genomes.shape(0) : 0;
    held.candidates.n = static_cast<int>(n);
    if (py::isinstance<RatingShape>(shape)) {
        const RatingShape& rating = held.candidates.rating.emplace(shape.cast<RatingShape>());
        rating.check_fits(name, config);
        require_shape(name + " genomes", genomes, {n, rating.genome_size()});
        return held;
    }
    const Network& network = held.candidates.network.emplace(shape.cast<Network>());
    if (network.fov != config.fov || network.n_actions() != config.n_actions()) {
        throw py::value_error(name + ": expected a network for fov " + std::to_string(config.fov) +
                              " and " + std::to_string(config.n_actions()) + " actions, got fov " +
                              std::to_string(network.fov) + " and " +
                              std::to_string(network.n_actions()) + " actions");
    }
    require_shape(name + " genomes", genomes, {n, network.genome_size()});
    return held;
}

HeldCandidates to_policy(const std::string& name, const py::object& given, const Config& config) {
    HeldCandidates held = to_candidates(name, given, config);
    if (held.candidates.n == 1) return held;
    throw py::value_error(name + ": expected a single genome, got " +
                          std::to_string(held.candidates.n));
}

void require_agents(int first, int last, const Config& config) {
    const int n_agents = config.n_agents();
    if (first < 0 || last > n_agents || first > last) {
        throw py::value_error("agents: expected a range in 0 to " + std::to_string(n_agents) +
                              ", got " + std::to_string(first) + " to " + std::to_string(last));
    }
    if (first >= config.n_pursuers || last <= config.n_pursuers) return;
    throw py::value_error("agents: expected agents of one team, got " + std::to_string(first) +
                          " to " + std::to_string(last));
}

}  // namespace matrixworld
