#include "solve/matrix_game.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matrixworld {

namespace {

// Entries are scaled to [1, 2]: what is smaller is rounding, and no pivot.
constexpr double kNone = 1e-10;
constexpr double kTie = 1e-12;    // ratios so near to each other are equal
constexpr double kGood = 1e-9;    // a gap of the certificate that rounding explains
constexpr int kQuickPivots = 60;  // then the rule that cannot cycle

// What a mixture of rows guarantees: its smallest mean over a column.
double guarantee(const double* matrix, int n_rows, int n_cols, const double* rows) {
    double least = HUGE_VAL;
    for (int j = 0; j < n_cols; ++j) {
        double mean = 0;
        for (int i = 0; i < n_rows; ++i) mean += rows[i] * matrix[i * n_cols + j];
        least = std::min(least, mean);
    }
    return least;
}

// What a mixture of columns concedes at most.
double concession(const double* matrix, int n_rows, int n_cols, const double* cols) {
    double most = -HUGE_VAL;
    for (int i = 0; i < n_rows; ++i) {
        most = std::max(most, std::inner_product(cols, cols + n_cols, matrix + i * n_cols, 0.0));
    }
    return most;
}

// Rounding may leave numbers a little below 0, and a sum that is not quite 1.
void normalize(double* weights, int n) {
    double total = 0;
    for (int i = 0; i < n; ++i) total += weights[i] = std::max(weights[i], 0.0);
    for (int i = 0; i < n; ++i) weights[i] /= total;
}

}  // namespace

GameValue MatrixGame::solve(const double* matrix, int n_rows, int n_cols, double* rows,
                            double* cols) {
    GameValue solved;
    const auto certify = [&] {
        const double least = guarantee(matrix, n_rows, n_cols, rows);
        return GameValue{least, concession(matrix, n_rows, n_cols, cols) - least};
    };
    if (find_saddle(matrix, n_rows, n_cols, rows, cols)) return certify();
    // Few constraints and many variables: the tableau's rows are long, its pivots few.
    const bool transposed = n_rows > n_cols;
    for (const bool careful : {false, true}) {
        fill(matrix, n_rows, n_cols, transposed);
        for (int n = 0; pivot_once(careful || n > kQuickPivots); ++n) continue;
        read(transposed ? cols : rows, transposed ? rows : cols);
        normalize(rows, n_rows);
        normalize(cols, n_cols);
        solved = certify();
        if (solved.gap < kGood) break;
    }
    return solved;
}

// A row and a column, neither of which has a better reply to the other.
bool MatrixGame::find_saddle(const double* matrix, int n_rows, int n_cols, double* rows,
                             double* cols) {
    most_.assign(matrix, matrix + n_cols);
    int best_row = 0;
    double best = -HUGE_VAL;
    for (int i = 0; i < n_rows; ++i) {
        const double* row = matrix + i * n_cols;
        const double least = *std::min_element(row, row + n_cols);
        if (least > best) {
            best = least;
            best_row = i;
        }
        for (int j = 0; j < n_cols; ++j) most_[j] = std::max(most_[j], row[j]);
    }
    const auto best_col = std::min_element(most_.begin(), most_.end());
    if (*best_col > best) return false;
    std::fill_n(rows, n_rows, 0.0);
    std::fill_n(cols, n_cols, 0.0);
    rows[best_row] = 1;
    cols[best_col - most_.begin()] = 1;
    return true;
}

// The programme of the columns' player. Transposed, the players change places and the signs with
// them. Entries are scaled to [1, 2], which changes no optimal strategy.
void MatrixGame::fill(const double* matrix, int n_rows, int n_cols, bool transposed) {
    const auto ends = std::minmax_element(matrix, matrix + n_rows * n_cols);
    const double low = *ends.first;
    const double high = *ends.second;
    const double scale = 1 / (high - low);
    n_constraints_ = transposed ? n_cols : n_rows;
    n_variables_ = transposed ? n_rows : n_cols;
    tableau_.resize(static_cast<std::size_t>(n_constraints_ + 1) * (n_variables_ + 1));
    for (int i = 0; i < n_constraints_; ++i) {
        for (int j = 0; j < n_variables_; ++j) {
            at(i, j) = 1 + scale * (transposed ? high - matrix[j * n_cols + i]
                                               : matrix[i * n_cols + j] - low);
        }
        at(i, n_variables_) = 1;
    }
    std::fill_n(&at(n_constraints_, 0), n_variables_, -1.0);
    at(n_constraints_, n_variables_) = 0;
    nonbasic_.resize(n_variables_);
    basic_.resize(n_constraints_);
    std::iota(nonbasic_.begin(), nonbasic_.end(), 0);
    std::iota(basic_.begin(), basic_.end(), n_variables_);
}

// Makes one variable basic; false when none improves the objective. Usually the one with the largest
// coefficient; `careful` by Bland's rule, the first that improves (Bland 1977, "New finite pivoting
// rules for the simplex method").
bool MatrixGame::pivot_once(bool careful) {
    int col = -1;
    for (int j = 0; j < n_variables_; ++j) {
        if (at(n_constraints_, j) >= -kNone) continue;
        if (col < 0 || (careful ? nonbasic_[j] < nonbasic_[col]
                                : at(n_constraints_, j) < at(n_constraints_, col))) {
            col = j;
        }
    }
    if (col < 0) return false;
    // The smallest ratio keeps all variables positive. Many are equal, because the bounds all begin as
    // 1: of those the largest pivot loses the fewest digits.
    double least = HUGE_VAL;
    for (int i = 0; i < n_constraints_; ++i) {
        if (at(i, col) > kNone) least = std::min(least, at(i, n_variables_) / at(i, col));
    }
    int row = -1;
    for (int i = 0; i < n_constraints_; ++i) {
        if (at(i, col) <= kNone || at(i, n_variables_) / at(i, col) > least + kTie) continue;
        if (row < 0 || (careful ? basic_[i] < basic_[row] : at(i, col) > at(row, col))) row = i;
    }
    if (row < 0) return false;  // only by rounding: the sum of the variables is bounded
    pivot(row, col);
    return true;
}

void MatrixGame::pivot(int row, int col) {
    const int width = n_variables_ + 1;
    double* const chosen = &at(row, 0);
    const double inverse = 1 / chosen[col];
    for (int j = 0; j < width; ++j) chosen[j] *= inverse;
    chosen[col] = inverse;
    for (int i = 0; i <= n_constraints_; ++i) {
        double* const other = &at(i, 0);
        const double factor = other[col];
        if (i == row || factor == 0) continue;
        other[col] = 0;
        for (int j = 0; j < width; ++j) other[j] -= factor * chosen[j];
    }
    std::swap(basic_[row], nonbasic_[col]);
}

// The solution and that of the dual programme.
void MatrixGame::read(double* constraints, double* variables) const {
    std::fill_n(constraints, n_constraints_, 0.0);
    std::fill_n(variables, n_variables_, 0.0);
    for (int i = 0; i < n_constraints_; ++i) {
        if (basic_[i] < n_variables_) variables[basic_[i]] = at(i, n_variables_);
    }
    for (int j = 0; j < n_variables_; ++j) {
        if (nonbasic_[j] >= n_variables_) {
            constraints[nonbasic_[j] - n_variables_] = at(n_constraints_, j);
        }
    }
}

}  // namespace matrixworld
