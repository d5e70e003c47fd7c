// Named arrays: the one form in which values cross between JavaScript and the engine, both ways.
// web/src/engine/heap.ts reads and writes the same two structs in the memory that both share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "play/output_fields.hpp"

namespace matrixworld {

// Four words of 32 bits each. A number is an array of one entry, a text an array of its bytes.
struct NamedArray {
    const char* name;
    std::int32_t dtype;  // a DType
    std::int32_t n;
    const void* data;
};
static_assert(sizeof(NamedArray) == 16, "heap.ts writes this layout");

struct NamedArrays {
    std::int32_t n;
    const NamedArray* arrays;
};

template <typename T>
constexpr DType dtype_of() {
    if constexpr (std::is_same_v<T, bool>) return DType::Bool;
    if constexpr (std::is_same_v<T, std::uint8_t>) return DType::UInt8;
    if constexpr (std::is_same_v<T, int>) return DType::Int32;
    if constexpr (std::is_same_v<T, std::uint64_t>) return DType::UInt64;
    if constexpr (std::is_same_v<T, float>) return DType::Float32;
    if constexpr (std::is_same_v<T, double>) return DType::Float64;
}

// What JavaScript passed. Arrays are copied out, never kept.
class Arguments {
  public:
    explicit Arguments(const NamedArrays* given) : given_(*given) {}

    bool has(const char* name) const { return find(name) != nullptr; }

    // All entries; none if there is no array of this name.
    template <typename T>
    std::vector<T> list(const char* name) const {
        const NamedArray* array = find(name);
        if (!array) return {};
        if (array->dtype != static_cast<int>(dtype_of<T>())) {
            throw std::invalid_argument(std::string(name) + ": expected dtype " +
                                        std::to_string(static_cast<int>(dtype_of<T>())) + ", got " +
                                        std::to_string(array->dtype));
        }
        // One entry after the other: the elements of a std::vector<bool> have no addresses.
        const auto* data = static_cast<const T*>(array->data);
        return std::vector<T>(data, data + array->n);
    }

    template <typename T>
    T number(const char* name) const {
        const std::vector<T> entries = list<T>(name);
        if (entries.size() == 1) return entries[0];
        throw std::invalid_argument(std::string(name) + ": expected one number, got " +
                                    std::to_string(entries.size()));
    }

    std::string text(const char* name) const {
        const std::vector<std::uint8_t> bytes = list<std::uint8_t>(name);
        return std::string(bytes.begin(), bytes.end());
    }

  private:
    const NamedArray* find(const char* name) const {
        for (int i = 0; i < given_.n; ++i) {
            if (std::strcmp(given_.arrays[i].name, name) == 0) return &given_.arrays[i];
        }
        return nullptr;
    }

    NamedArrays given_;
};

// The results of a call. They stay until the next call; JavaScript copies them.
class Outputs {
  public:
    void clear() {
        memory_.clear();
        names_.clear();
        arrays_.clear();
    }

    // Adds an array of n entries and returns its memory, which stays where it is.
    std::uint8_t* add(const std::string& name, DType dtype, std::size_t n) {
        names_.push_back(name);
        memory_.emplace_back(n * item_size(dtype));
        arrays_.push_back({names_.back().c_str(), static_cast<std::int32_t>(dtype),
                           static_cast<std::int32_t>(n), memory_.back().data()});
        return memory_.back().data();
    }

    template <typename T>
    void add(const std::string& name, const T* data, std::size_t n) {
        std::uint8_t* out = add(name, dtype_of<T>(), n);
        if (n > 0) std::memcpy(out, data, n * sizeof(T));
    }

    const NamedArrays* arrays() {
        all_ = {static_cast<std::int32_t>(arrays_.size()), arrays_.data()};
        return &all_;
    }

  private:
    // Deques: their elements do not move when others are added.
    std::deque<std::vector<std::uint8_t>> memory_;
    std::deque<std::string> names_;
    std::vector<NamedArray> arrays_;
    NamedArrays all_{0, nullptr};
};

}  // namespace matrixworld
