// Team policies that Python passes to the engine: networks with genomes, and names of scripts.
#pragma once

#include <string>

#include "bindings/numpy_arrays.hpp"
#include "play/policy.hpp"

namespace matrixworld {

// Candidates and the Python array that owns the memory of their genomes.
struct HeldCandidates {
    Candidates candidates;
    Array<float> genomes;
};

// From a script's name, from tables, or from (Network, genomes (n, genome_size) float32). `name` is the argument's
// in error messages.
HeldCandidates to_candidates(const std::string& name, const py::object& given,
                             const Config& config);
// The same for a single genome.
HeldCandidates to_policy(const std::string& name, const py::object& given, const Config& config);

// Throws ValueError unless [first, last) are agents of one team.
void require_agents(int first, int last, const Config& config);

}  // namespace matrixworld
