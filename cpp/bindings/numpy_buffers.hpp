// The caller's NumPy arrays, checked against the table of output fields, as memory to write to.
#pragma once

#include "bindings/numpy_arrays.hpp"
#include "play/buffers.hpp"

namespace matrixworld {

py::dtype numpy_dtype(DType dtype);

// The shape of an array of this field, with these leading axes.
Shape shape_of(const OutputField& field, const Config& config, Shape leading);

// Buffers and the Python arrays that own their memory.
struct HeldBuffers {
    Buffers buffers;
    py::dict arrays;
};

// `arrays` holds arrays by the names of fields: for one world those of `world_fields`, for a batch
// also those of `batch_fields`, each with the leading axis of worlds. Throws ValueError or TypeError
// for another name, shape, dtype or memory layout.
HeldBuffers hold_world(const Config& config, const py::dict& arrays);
HeldBuffers hold_batch(const Config& config, int n_worlds, const py::dict& arrays);

}  // namespace matrixworld
