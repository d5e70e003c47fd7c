// Two maps of the grid from which windows (the square views of agents) are read quickly: `Bitboard`
// keeps one bit a cell, `Plane` one byte. Both have a margin of half a window on every side, so
// that a window around any cell is read without a test for the border.
//
//     Bitboard pursuers(grid, fov / 2);
//     pursuers.set(row, col);
//     const Bitboard::Reader reader = pursuers.window(row - fov / 2, col - fov / 2);
//     const Bitboard::Word first_row = reader.row(0, fov);   // bit c is column c of the window
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "grid/grid.hpp"

namespace matrixworld {

// One bit a cell; the margin is empty. Words are read as little-endian, which holds on every
// processor that the kernels are built for.
class Bitboard {
  public:
    using Word = std::uint64_t;
    // The widest row of a window that one unaligned read returns: 64 bits less a shift of up to 7.
    static constexpr int kMaxWidth = 56;

    // The last row may be read up to one word beyond its end, so there is room for it.
    Bitboard(const Grid& grid, int margin)
        : stride_((grid.cols() + 2 * margin + 7) / 8),
          margin_(margin),
          bits_(static_cast<std::size_t>(grid.rows() + 2 * margin) * stride_ + sizeof(Word), 0) {}

    void set(int row, int col) { byte(row, col) |= bit(col); }
    void clear(int row, int col) { byte(row, col) &= static_cast<std::uint8_t>(~bit(col)); }

    // Reads the rows of a window one below the other.
    struct Reader {
        const std::uint8_t* at;
        int stride;
        int shift;

        // The first `width` cells of the window's row `r`, the first in the lowest bit.
        // Precondition: width <= kMaxWidth.
        Word row(int r, int width) const {
            Word word;
            std::memcpy(&word, at + static_cast<std::ptrdiff_t>(r) * stride, sizeof(Word));
            return (word >> shift) & ((Word{1} << width) - 1);
        }
    };

    // The window whose first cell is (row, col), which may lie in the margin. Columns beyond the
    // eastern margin may be read, but their bits mean nothing.
    Reader window(int row, int col) const {
        const int x = col + margin_;
        return {&bits_[index(row, x)], stride_, x & 7};
    }

  private:
    std::size_t index(int row, int x) const {
        return static_cast<std::size_t>(row + margin_) * stride_ + (x >> 3);
    }
    std::uint8_t& byte(int row, int col) { return bits_[index(row, col + margin_)]; }
    std::uint8_t bit(int col) const {
        return static_cast<std::uint8_t>(1 << ((col + margin_) & 7));
    }

    int stride_;  // bytes a row
    int margin_;
    std::vector<std::uint8_t> bits_;
};

// One byte a cell, the layout of the views themselves: a window is copied row by row. Cells and
// margin begin with a given value.
class Plane {
  public:
    // Rows may be copied in whole pieces of this many bytes: there is room behind the last one.
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
