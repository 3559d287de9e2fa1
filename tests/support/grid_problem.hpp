#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/problem.hpp"

namespace tripus::testing {

/// A nonlinear function on a square grid of side^2 variables, sparse and well conditioned:
/// sum_i (x_i^2 / 2 - b_i x_i) + sum_(neighbours i,j) sqrt(1 + (x_i - x_j)^2).
class GridProblem : public solver::Problem {
 public:
  explicit GridProblem(std::size_t side) : side_(side) {
    pattern_.column_start.push_back(0);
    for (std::size_t j = 0; j < dimension(); ++j) {
      pattern_.row.push_back(static_cast<std::int32_t>(j));
      if (has_right(j)) pattern_.row.push_back(static_cast<std::int32_t>(j + 1));
      if (has_down(j)) pattern_.row.push_back(static_cast<std::int32_t>(j + side_));
      pattern_.column_start.push_back(static_cast<std::int64_t>(pattern_.row.size()));
    }
  }

  std::size_t dimension() const override { return side_ * side_; }

  bool evaluate(std::span<const double> x, solver::Order order,
                std::unique_ptr<solver::Evaluation>& into) const override {
    At& at = solver::reuse<At>(into, *this);
    at.f = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double b = 10 * std::sin(static_cast<double>(i));
      at.f += 0.5 * x[i] * x[i] - b * x[i];
      at.g[i] = x[i] - b;
    }
    const auto pair = [&](std::size_t i, std::size_t j, std::vector<double>& second) {
      const double s = x[i] - x[j], r = std::sqrt(1 + s * s);
      at.f += r;
      at.g[i] += s / r;
      at.g[j] -= s / r;
      if (order == solver::Order::kSecond) second[i] = 1 / (r * r * r);
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (has_right(i)) pair(i, i + 1, at.right);
      if (has_down(i)) pair(i, i + side_, at.down);
    }
    return true;
  }

  const solver::SparsityPattern& hessian_pattern() const override { return pattern_; }

 private:
  struct At final : solver::Evaluation {
    explicit At(const GridProblem& problem)
        : of(&problem), g(problem.dimension()), right(g), down(g) {}

    bool is_of(const GridProblem& problem) const { return of == &problem; }
    std::span<const double> gradient() const override { return g; }
    double value() const override { return f; }

    void hessian_values(std::span<double> values) const override {
      std::vector<double> diagonal(of->dimension());
      hessian_diagonal_blocks(1, diagonal);
      std::size_t k = 0;
      for (std::size_t j = 0; j < of->dimension(); ++j) {
        values[k++] = diagonal[j];
        if (of->has_right(j)) values[k++] = -right[j];
        if (of->has_down(j)) values[k++] = -down[j];
      }
    }

    void hessian_times(std::span<const double> v, std::span<double> Hv) const override {
      std::copy(v.begin(), v.end(), Hv.begin());
      const auto pair = [&](std::size_t i, std::size_t j, double second) {
        Hv[i] += second * (v[i] - v[j]);
        Hv[j] -= second * (v[i] - v[j]);
      };
      for (std::size_t i = 0; i < v.size(); ++i) {
        if (of->has_right(i)) pair(i, i + 1, right[i]);
        if (of->has_down(i)) pair(i, i + of->side_, down[i]);
      }
    }

    void hessian_diagonal_blocks(std::size_t b, std::span<double> blocks) const override {
      std::fill(blocks.begin(), blocks.end(), 0.0);
      const auto entry = [&](std::size_t i, std::size_t j) -> double& {
        return blocks[i / b * b * b + i % b * b + j % b];
      };
      const auto pair = [&](std::size_t i, std::size_t j, double second) {
        entry(i, i) += second;
        entry(j, j) += second;
        if (i / b == j / b) {
          entry(i, j) -= second;
          entry(j, i) -= second;
        }
      };
      for (std::size_t i = 0; i < of->dimension(); ++i) {
        entry(i, i) += 1;
        if (of->has_right(i)) pair(i, i + 1, right[i]);
        if (of->has_down(i)) pair(i, i + of->side_, down[i]);
      }
    }

    const GridProblem* of;
    double f = 0;
    std::vector<double> g, right, down;  // the latter: second derivatives of the pairs
  };

  bool has_right(std::size_t i) const { return i % side_ + 1 < side_; }
  bool has_down(std::size_t i) const { return i + side_ < side_ * side_; }

  std::size_t side_;
  solver::SparsityPattern pattern_;
};

}  // namespace tripus::testing
