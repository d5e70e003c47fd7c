// The caller's arrays, into which worlds write their output fields.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "play/output_fields.hpp"

namespace matrixworld {

// Any of the output fields, each with the memory of all worlds one after the other. Which of them
// are there is decided once, so that a step calls one function for each field and tests nothing.
class Buffers {
  public:
    // Writes this field to `data`, (W, ...), from now on; as float32 where `floats` says so.
    void add(const OutputField& field, const Config& config, void* data, bool floats = false) {
        has_inputs_ |= !field.axes.empty() && field.axes.back() == Axis::Inputs;
        const DType dtype = floats ? DType::Float32 : field.dtype;
        columns_[index(field.written)].push_back({floats ? field.write_floats : field.write,
                                                  static_cast<std::uint8_t*>(data),
                                                  field.n_items(config) * item_size(dtype)});
    }

    // Is any field written at this time?
    bool has(Written when) const { return !columns_[index(when)].empty(); }

    // Are inputs of moves written? They need the positions that networks read.
    bool has_inputs() const { return has_inputs_; }

    // Writes world w's part of all fields that are written at this time.
    void write(Written when, const OutputSource& source, std::size_t w) const {
        for (const Column& column : columns_[index(when)]) {
            column.write(source, column.data + w * column.world_size);
        }
    }

  private:
    struct Column {
        Writer write;
        std::uint8_t* data;
        std::size_t world_size;  // bytes
    };

    static std::size_t index(Written when) { return static_cast<std::size_t>(when); }

    std::array<std::vector<Column>, kTimesWritten> columns_;
    bool has_inputs_ = false;
};

}  // namespace matrixworld
