// The geometry of the grid. Cells are numbered on a frame that is one cell wider on every side,
// so that a step from any cell of the world leads to a numbered cell and needs no test for the edge
// of the grid: the outermost ring is the border. Every cell index in the engine is one of these.
//
//     const Grid grid(rows, cols);
//     const int target = grid.cell(row, col) + grid.delta(move);
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "grid/rules.hpp"

namespace matrixworld {

constexpr int kGone = -1;  // the cell of an agent that is on no cell

// Rows and columns that each move adds; move 0 is to stay.
constexpr std::array<int, kDiagonalMoves> kRowStep = {0, -1, 0, 1, 0, -1, 1, 1, -1};
constexpr std::array<int, kDiagonalMoves> kColStep = {0, 0, 1, 0, -1, 1, 1, -1, -1};
// The move that undoes each move.
constexpr std::array<int, kDiagonalMoves> kOpposite = {0, 3, 4, 1, 2, 7, 8, 5, 6};

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
    int n_cells() const { return (rows_ + 2) * stride_; }  // with the ring of the border

    int cell(int row, int col) const { return (row + 1) * stride_ + col + 1; }
    // What a move adds to a cell's index.
    int delta(int move) const { return delta_[move]; }

    // The row of a cell is asked for once an agent and turn, and an integer division would be its
    // main cost. One multiplication by the rounded-up reciprocal gives the same quotient as long as
    // cell * stride < 2^40; the largest grid has fewer than 2^25 cells and 2^13 columns.
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

// Numbers the cells so that cells from which the same part of the border is seen have the same
// number. Whatever depends on the visible border alone is then kept once for each number: there are
// at most fov * fov of them, however large the grid.
class BorderCases {
  public:
    BorderCases(const Grid& grid, int fov)
        : row_case_(cases_along(grid.rows(), fov)),
          col_case_(cases_along(grid.cols(), fov)),
          n_cols_(col_case_.back() + 1) {}

    int number(int row, int col) const { return row_case_[row] * n_cols_ + col_case_[col]; }
    int n_cases() const { return (row_case_.back() + 1) * n_cols_; }

  private:
    // Along one side: a number of its own for each of the first and last fov / 2 positions, one
    // number for all positions between them, from which no border is seen.
    static std::vector<int> cases_along(int side, int fov) {
        const int cases = std::min(side, fov);
        const int middle = std::min(fov / 2, cases - 1);
        std::vector<int> numbers(side);
        for (int i = 0; i < side; ++i) {
            numbers[i] = std::min(i, std::max(middle, i - (side - cases)));
        }
        return numbers;
    }

    std::vector<int> row_case_;  // by row
    std::vector<int> col_case_;  // by column
    int n_cols_;
};

}  // namespace matrixworld
