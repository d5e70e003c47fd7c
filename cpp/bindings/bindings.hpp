// The parts of the extension module, each in a file of its own.
#pragma once

#include <pybind11/pybind11.h>

namespace matrixworld {

void bind_worlds(pybind11::module_& m);    // World, Batch
void bind_rollouts(pybind11::module_& m);  // Network, rollout, record
void bind_solve(pybind11::module_& m);     // States

}  // namespace matrixworld
