#pragma once

#include "solver/method.hpp"

/// The minimisers, one a source file; solver/methods.cpp lists them.
namespace tripus::solver::detail {

Summary newton(Problem& problem, std::span<double> x, const Options& options);
Summary newton_cg(Problem& problem, std::span<double> x, const Options& options);
Summary newton_cg_block(Problem& problem, std::span<double> x, const Options& options);
Summary ceres_lbfgs(Problem& problem, std::span<double> x, const Options& options);
Summary ceres_bfgs(Problem& problem, std::span<double> x, const Options& options);
Summary ceres_cg(Problem& problem, std::span<double> x, const Options& options);
Summary ceres_steepest_descent(Problem& problem, std::span<double> x, const Options& options);
Summary ceres_lm(Problem& problem, std::span<double> x, const Options& options);

}  // namespace tripus::solver::detail
