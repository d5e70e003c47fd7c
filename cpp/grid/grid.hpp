// The geometry of the grid. Cells are numbered on a frame that is one cell wider on every side,
// so that a step from any cell of the world lands on a numbered cell: the outermost ring is the
// border. Every cell index in the engine is one of these.
#pragma once

#include <array>
#include <cstdint>

#include "grid/rules.hpp"

namespace matrixworld {

constexpr int kGone = -1;  // the cell of an agent that is on no cell

// Rows and columns that each action adds.
constexpr std::array<int, kDiagonalMoves> kRowStep = {0, -1, 0, 1, 0, -1, 1, 1, -1};
constexpr std::array<int, kDiagonalMoves> kColStep = {0, 0, 1, 0, -1, 1, 1, -1, -1};
// The action that undoes each action.
constexpr std::array<int, kDiagonalMoves> kOpposite = {0, 3, 4, 1, 2, 7, 8, 5, 6};

// What a cell is made of.
enum CellKind : std::uint8_t { kFree = 0, kObstacle = 1, kBorder = 2 };

class Grid {
  public:
    Grid(int rows, int cols)
        : rows_(rows), cols_(cols), stride_(cols + 2), reciprocal_(kScale / stride_ + 1) {
        for (int move = 0; move < kDiagonalMoves; ++move) {
            delta_[move] = kRowStep[move] * stride_ + kColStep[move];
        }
    }

    int rows() const { return rows_; }
    int cols() const { return cols_; }
    int n_cells() const { return (rows_ + 2) * stride_; }  // the border's ring included

    int cell(int row, int col) const { return (row + 1) * stride_ + col + 1; }
    int delta(int move) const { return delta_[move]; }

    // Division by the stride as one multiplication: exact while cell * stride < 2^40.
    int row(int cell) const {
        return static_cast<int>((static_cast<std::uint64_t>(cell) * reciprocal_) >> kShift) - 1;
    }
    int col(int cell) const { return cell - (row(cell) + 1) * stride_ - 1; }

  private:
    static constexpr int kShift = 40;
    static constexpr std::uint64_t kScale = std::uint64_t{1} << kShift;

    int rows_;
    int cols_;
    int stride_;
    std::uint64_t reciprocal_;
    std::array<int, kDiagonalMoves> delta_{};
};

}  // namespace matrixworld
