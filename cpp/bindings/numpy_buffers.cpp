#include "bindings/numpy_buffers.hpp"

namespace matrixworld {

py::dtype numpy_dtype(DType dtype) {
    switch (dtype) {
        case DType::Bool:
            return py::dtype::of<bool>();
        case DType::UInt8:
            return py::dtype::of<std::uint8_t>();
        case DType::Int32:
            return py::dtype::of<std::int32_t>();
        case DType::Int64:
            return py::dtype::of<std::int64_t>();
        case DType::UInt64:
            return py::dtype::of<std::uint64_t>();
        case DType::Float32:
            return py::dtype::of<float>();
        case DType::Float64:
            return py::dtype::of<double>();
    }
    throw std::logic_error("a dtype without a NumPy dtype");
}

Shape shape_of(const OutputField& field, const Config& config, Shape leading) {
    for (const Axis axis : field.axes) leading.push_back(size_of(axis, config));
    return leading;
}

namespace {

using Tables = std::vector<const OutputFields*>;

const OutputField* find_in(const Tables& tables, const std::string& name) {
    for (const OutputFields* fields : tables) {
        if (const OutputField* field = find_field(*fields, name)) return field;
    }
    return nullptr;
}

// A wrong name is mostly a spelling mistake: the message lists all names.
[[noreturn]] void refuse_names(const Tables& tables, const py::dict& arrays) {
    std::string names;
    for (const OutputFields* fields : tables) {
        for (const OutputField& field : *fields) names += (names.empty() ? "" : ", ") + field.name;
    }
    throw py::value_error("buffers: expected some of " + names + ", got " +
                          py::str(py::list(arrays)).cast<std::string>());
}

// The memory of one array, after all checks.
void add_array(const OutputField& field, const Config& config, const Shape& leading,
               const py::handle& given, Buffers& buffers) {
    if (!py::isinstance<py::array>(given)) {
        throw py::type_error(field.name + ": expected a NumPy array, got " +
                             py::type::handle_of(given).attr("__name__").cast<std::string>());
    }
    const auto array = py::reinterpret_borrow<py::array>(given);
    // Views are the one kind of field with a choice of dtypes.
    const bool floats = field.write_floats && has_dtype(array, py::dtype::of<float>());
    if (!floats) require_dtype(field.name, array, numpy_dtype(field.dtype));
    void* const data = writeable(field.name, array, shape_of(field, config, leading));
    buffers.add(field, config, data, floats);
}

// Goes through the caller's arrays, not through the table: reading a single array of a world, which
// environments do all the time, then costs one search.
Buffers add_arrays(const Tables& tables, const Config& config, const Shape& leading,
                   const py::dict& arrays) {
    Buffers buffers;
    for (const auto& [name, array] : arrays) {
        const bool is_name = py::isinstance<py::str>(name);
        const OutputField* field = is_name ? find_in(tables, name.cast<std::string>()) : nullptr;
        if (!field) refuse_names(tables, arrays);
        add_array(*field, config, leading, array, buffers);
    }
    return buffers;
}

}  // namespace

HeldBuffers hold_world(const Config& config, const py::dict& arrays) {
    return {add_arrays({&world_fields()}, config, {}, arrays), arrays};
}

HeldBuffers hold_batch(const Config& config, int n_worlds, const py::dict& arrays) {
    py::dict kept = arrays.attr("copy")();  // the caller may change its own dict later
    Buffers buffers = add_arrays({&world_fields(), &batch_fields()}, config, {n_worlds}, kept);
    return {std::move(buffers), std::move(kept)};
}

}  // namespace matrixworld
