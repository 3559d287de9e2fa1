#pragma once

#include "solver/method.hpp"

/// Ceres's minimisers. They lie apart from their rows in solver/methods, so that a program can load
/// them when they are called.
namespace tripus::solver::detail {

Summary ceres_lbfgs(const Problem& problem, std::span<double> x, const Options& options);
Summary ceres_bfgs(const Problem& problem, std::span<double> x, const Options& options);
Summary ceres_cg(const Problem& problem, std::span<double> x, const Options& options);
Summary ceres_steepest_descent(const Problem& problem, std::span<double> x, const Options& options);
Summary ceres_lm(const Problem& problem, std::span<double> x, const Options& options);

}  // namespace tripus::solver::detail
