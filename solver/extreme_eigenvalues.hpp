#pragma once

#include <vector>

#include "solver/problem.hpp"

namespace tripus::solver {

/// The extreme eigenvalues of a Hessian, and the unit eigenvector [n] of the smallest.
struct ExtremeEigenvalues {
  double smallest = 0;
  double largest = 0;
  std::vector<double> slowest = {};
  double condition() const { return largest / smallest; }
};

/// Of the Hessian of an evaluation of second order, by Lanczos
/// iterations on it and on its inverse, which conjugate gradients apply: no matrix is stored.
/// Accuracy: some 1e-10, relative, unless the Hessian is singular to rounding; then smallest is 0
/// and slowest is empty. The same problem gives the same bits.
/// Source: G. Golub, C. Van Loan, Matrix Computations, chapter 10.
ExtremeEigenvalues extreme_eigenvalues(const Evaluation& at);

}  // namespace tripus::solver
