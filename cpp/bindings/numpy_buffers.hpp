// Arrays of the caller that worlds write to.
#pragma once

#include "bindings/numpy_arrays.hpp"
#include "play/buffers.hpp"

namespace matrixworld {

// The caller's arrays, checked, with what keeps them alive.
struct HeldBuffers {
    Buffers pointers;
    py::dict arrays;
};

// Arrays by name, of these leading axes: those of a batch may also tell of its episodes. Throws
// ValueError and TypeError for one of another name, shape, dtype or layout.
HeldBuffers hold_world(const Config& config, const py::dict& arrays);
HeldBuffers hold_batch(const Config& config, int n_worlds, const py::dict& arrays);

}  // namespace matrixworld
