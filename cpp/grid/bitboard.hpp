// A bitmap of the grid, from which a window of cells is read in a few operations.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "grid/grid.hpp"

namespace matrixworld {

// One bit a cell, with a margin of empty cells on every side so that a window around any cell can
// be read without a test. (Words are read as little-endian, as on every processor that the kernels
// are built for.)
class Bitboard {
  public:
    static constexpr int kMaxWidth = 56;  // of a window: with a shift below 8, it fits one word

    Bitboard(const Grid& grid, int margin)
        : stride_((grid.cols() + 2 * margin + 7) / 8),
          margin_(margin),
          bits_(static_cast<std::size_t>(grid.rows() + 2 * margin) * stride_ + sizeof(Word), 0) {}

    void set(int row, int col) { byte(row, col) |= bit(col); }
    void clear(int row, int col) { byte(row, col) &= static_cast<std::uint8_t>(~bit(col)); }
    void clear_all() { std::fill(bits_.begin(), bits_.end(), std::uint8_t{0}); }

    using Word = std::uint64_t;

    // Reads the rows of a window one below the other.
    struct Reader {
        const std::uint8_t* at;
        int stride;
        int shift;

        // `width` (at most kMaxWidth) cells of the window's row `r`, the first in the lowest bit.
        Word row(int r, int width) const {
            Word word;
            std::memcpy(&word, at + static_cast<std::ptrdiff_t>(r) * stride, sizeof(Word));
            return (word >> shift) & ((Word{1} << width) - 1);
        }
    };

    // A window with its first cell at (row, col). Its cells may lie in the margin, and beyond it
    // only to the east, where nothing sensible is read.
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

}  // namespace matrixworld
