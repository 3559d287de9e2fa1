#include "solver/detail/ceres_methods.hpp"

namespace tripus::solver::registered_methods {

std::span<const Method> ceres() {
  static constexpr Method kRows[] = {
      {"ceres-lbfgs", "limited-memory BFGS (Ceres)", false, detail::ceres_lbfgs, 3},
      {"ceres-bfgs", "BFGS with a dense matrix, up to 1000 variables (Ceres)", false,
       detail::ceres_bfgs, 4},
      {"ceres-cg", "nonlinear conjugate gradients, Polak-Ribiere (Ceres)", false, detail::ceres_cg,
       5},
      {"ceres-steepest-descent", "steepest descent with a Wolfe line search (Ceres)", false,
       detail::ceres_steepest_descent, 6},
      {"ceres-lm", "Levenberg-Marquardt on gradient = 0 (Ceres)", true, detail::ceres_lm, 7},
  };
  return kRows;
}

}  // namespace tripus::solver::registered_methods
