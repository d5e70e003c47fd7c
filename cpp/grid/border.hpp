// From which places the border looks alike.
#pragma once

#include <algorithm>
#include <vector>

#include "grid/grid.hpp"

namespace matrixworld {

// Numbers the cells of the grid so that cells from which the same part of the border is seen have
// the same number: at most fov * fov of them, however large the grid.
class BorderCases {
  public:
    BorderCases(const Grid& grid, int fov)
        : row_case_(along(grid.rows(), fov)),
          col_case_(along(grid.cols(), fov)),
          n_cols_(col_case_.back() + 1) {}

    int number(int row, int col) const { return row_case_[row] * n_cols_ + col_case_[col]; }
    int n_cases() const { return (row_case_.back() + 1) * n_cols_; }

  private:
    static std::vector<int> along(int side, int fov) {
        const int cases = std::min(side, fov);
        const int middle = std::min(fov / 2, cases - 1);
        std::vector<int> numbers(side);
        for (int place = 0; place < side; ++place) {
            numbers[place] = std::min(place, std::max(middle, place - (side - cases)));
        }
        return numbers;
    }

    std::vector<int> row_case_;  // by row
    std::vector<int> col_case_;  // by column
    int n_cols_;
};

}  // namespace matrixworld
