// Checks of NumPy arrays that Python passes to the engine: shapes, dtypes, integers. The engine
// itself trusts its memory, so every array passes through here first.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <vector>

#include "grid/rules.hpp"

namespace matrixworld {

namespace py = pybind11;

template <typename T>
using Array = py::array_t<T, py::array::c_style>;
using Shape = std::vector<py::ssize_t>;

// A shape of sizes of any width: a browser counts in 32 bits.
template <typename... Sizes>
Shape shape(Sizes... sizes) {
    return {static_cast<py::ssize_t>(sizes)...};
}

// The shape as Python prints a tuple.
inline std::string text(const Shape& shape) {
    std::string out = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) {
        out += (i ? ", " : "") + std::to_string(shape[i]);
    }
    return out + (shape.size() == 1 ? ",)" : ")");
}

inline Shape shape_of(const py::array& array) {
    return Shape(array.shape(), array.shape() + array.ndim());
}

inline void require_shape(const std::string& name, const py::array& array, const Shape& expected) {
    if (shape_of(array) == expected) return;
    throw py::value_error(name + ": expected shape " + text(expected) + ", got " +
                          text(shape_of(array)));
}

// The name of a dtype. By handle, since pybind11 3.0.0 finds several conversions of an object.
inline std::string text(const py::dtype& dtype) {
    return py::str(py::handle(dtype)).cast<std::string>();
}

// Equal dtypes may be several objects, as that of an array from a pickle.
inline bool has_dtype(const py::array& array, const py::dtype& expected) {
    const py::dtype own = array.dtype();
    return own.is(expected) || own.equal(expected);
}

inline void require_dtype(const std::string& name, const py::array& array,
                          const py::dtype& expected) {
    if (has_dtype(array, expected)) return;
    throw py::type_error(name + ": expected dtype " + text(expected) + ", got " +
                         text(array.dtype()));
}

// Calls use(pointer) with the integers of an array of this shape. The pointer has the array's own
// type, so that actions of any usual dtype are read without a conversion.
template <typename Use>
void with_integers(const std::string& name, const py::array& given, const Shape& shape, Use use) {
    require_shape(name, given, shape);
    // A copy only where the array is not contiguous.
    const py::array array = py::array::ensure(given, py::array::c_style);
    const auto is = [&](auto integer) {
        return has_dtype(array, py::dtype::of<decltype(integer)>());
    };
    if (is(std::uint8_t{})) return use(static_cast<const std::uint8_t*>(array.data()));
    if (is(std::int8_t{})) return use(static_cast<const std::int8_t*>(array.data()));
    if (is(std::int32_t{})) return use(static_cast<const std::int32_t*>(array.data()));
    if (is(std::int64_t{})) return use(static_cast<const std::int64_t*>(array.data()));
    throw py::type_error(name + ": expected dtype uint8, int8, int32 or int64, got " +
                         text(array.dtype()));
}

inline void require_index(const char* name, std::int32_t index, int n) {
    if (index >= 0 && index < n) return;
    throw py::value_error(std::string(name) + ": expected 0 to " + std::to_string(n - 1) +
                          ", got " + std::to_string(index));
}

// The memory of an array that the engine writes to. Nothing may be converted here: a converted copy
// would be written to instead of the caller's array.
inline void* writeable(const std::string& name, const py::array& array, const Shape& shape) {
    require_shape(name, array, shape);
    if (!(array.flags() & py::array::c_style) || !array.writeable()) {
        throw py::value_error(name + ": expected a writeable C-contiguous array");
    }
    return const_cast<void*>(array.data());
}

inline std::int64_t* writeable_actions(const py::array& array, const Shape& shape) {
    require_dtype("actions", array, py::dtype::of<std::int64_t>());
    return static_cast<std::int64_t*>(writeable("actions", array, shape));
}

// A map of obstacles, (rows, cols) uint8; None gives an empty one.
inline ByteArray to_map(const py::object& map) {
    if (map.is_none()) return {};
    const auto array = map.cast<Array<std::uint8_t>>();
    return Eigen::Map<const ByteArray>(array.data(), array.size());
}

}  // namespace matrixworld
