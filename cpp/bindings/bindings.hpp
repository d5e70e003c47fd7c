// The parts of the extension module.
#pragma once

#include <pybind11/pybind11.h>

namespace matrixworld {

void bind_worlds(pybind11::module_& m);
void bind_rollouts(pybind11::module_& m);

}  // namespace matrixworld
