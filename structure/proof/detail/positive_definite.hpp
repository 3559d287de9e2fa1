#pragma once

#include <Eigen/SparseCore>

namespace tripus::structure::detail {

/// A symmetric matrix in balls: every entry is within `radius` of `mid`. Lower triangles.
struct EnclosedMatrix {
  Eigen::SparseMatrix<double> mid;
  Eigen::SparseMatrix<double> radius;
};

/// A number mu >= 0, rounded down, with A - mu I positive semidefinite for every symmetric member
/// A; 0 where none is shown. A factorisation in floating point that runs through proves it:
/// docs/theory.md (101). Diagonal entries of `mid` should be of one size.
double least_eigenvalue_bound(const EnclosedMatrix& matrix);

}  // namespace tripus::structure::detail
