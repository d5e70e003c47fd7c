// A byte for each cell of the grid, from which a window of cells is copied row by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"

namespace matrixworld {

// With a margin on every side, so that a window around any cell can be read without a test, and
// room behind it, so that rows can be read in pieces of kPiece bytes.
class Plane {
  public:
    static constexpr int kPiece = 16;

    Plane(const Grid& grid, int margin, std::uint8_t value)
        : stride_(grid.cols() + 2 * margin),
          margin_(margin),
          bytes_(static_cast<std::size_t>(grid.rows() + 2 * margin) * stride_ + kPiece, value) {}

    std::uint8_t& at(int row, int col) { return bytes_[index(row, col)]; }

    // The first cell of a window, which may lie in the margin; its rows are `stride` bytes apart.
    const std::uint8_t* window(int row, int col) const { return &bytes_[index(row, col)]; }
    int stride() const { return stride_; }

  private:
    std::size_t index(int row, int col) const {
        return static_cast<std::size_t>(row + margin_) * stride_ + col + margin_;
    }

    int stride_;
    int margin_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace matrixworld
