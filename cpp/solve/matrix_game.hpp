// Zero-sum matrix games, solved exactly: the rows' player receives the entry, the columns' player
// pays it, and both choose at the same time.
//
//     MatrixGame game;                                  // memory, one for each thread
//     const GameValue solved = game.solve(matrix, n_rows, n_cols, rows, cols);
//
// Most games have a saddle point, at which neither player mixes. The others are linear programmes
// (Dantzig 1951, "A proof of the equivalence of the programming problem and the game problem"),
// solved by the simplex method on a dense tableau. Whatever found the strategies, the certificate
// is computed from them and the matrix: what each of them guarantees against all replies.
#pragma once

#include <vector>

namespace matrixworld {

struct GameValue {
    double value = 0;  // what the strategy of the rows guarantees
    double gap = 0;    // what the strategy of the columns concedes at most, minus that; rounding
};

class MatrixGame {
  public:
    // Writes optimal probabilities of the rows (n_rows) and of the columns (n_cols). The matrix is
    // (n_rows, n_cols), row by row.
    GameValue solve(const double* matrix, int n_rows, int n_cols, double* rows, double* cols);

  private:
    bool find_saddle(const double* matrix, int n_rows, int n_cols, double* rows, double* cols);
    void fill(const double* matrix, int n_rows, int n_cols, bool transposed);
    bool pivot_once(bool careful);
    void pivot(int row, int col);
    void read(double* constraints, double* variables) const;

    double& at(int row, int col) { return tableau_[row * (n_variables_ + 1) + col]; }
    double at(int row, int col) const { return tableau_[row * (n_variables_ + 1) + col]; }

    // Maximize the sum of the variables, each at least 0, where every constraint, a positive
    // combination of them, is at most 1. The last row is the objective, the last column the bound.
    int n_constraints_ = 0;
    int n_variables_ = 0;
    std::vector<double> tableau_;
    std::vector<int> basic_;     // by row: a variable, or n_variables_ + the constraint's slack
    std::vector<int> nonbasic_;  // by column
    std::vector<double> most_;   // by column of the matrix: its largest entry
};

}  // namespace matrixworld
