#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "base/registry.hpp"
#include "solver/problem.hpp"
#include "solver/run.hpp"

namespace tripus::integrators {

/// Writes J v into Jv; [n] each.
using Jacobian = std::function<void(std::span<const double> v, std::span<double> Jv)>;

/// A vector field dx/dt = F(x) made from the gradient g and the Hessian H of a Problem, whose zeros
/// are those of g.
class Field {
 public:
  virtual ~Field() = default;

  /// Writes F(x) into velocity [n], g(x) into gradient [n] and max|g|. Returns false where F is not
  /// defined or not finite. Counts in `run`. Keeps memory for the next call, and nothing else.
  virtual bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                        std::span<double> gradient, double& max_gradient) = 0;

  /// -(dF/dx), or its leading part near a zero of g, at x [n] with the evaluation of second order
  /// there. What is returned keeps references to both and to this.
  virtual Jacobian jacobian(std::span<const double> x, const solver::Evaluation& at) const = 0;

  /// A step that need not be exceeded, whatever the stability limit.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }

  /// Whether |g| (Euclidean) decreases along every trajectory where the problem is convex.
  virtual bool contractive() const { return true; }
};

/// One line of the table of flows.
struct Flow {
  std::string_view name;         ///< as typed after --method flow:
  std::string_view description;  ///< one line for `tripus methods`
  std::unique_ptr<Field> (*make)(const solver::Problem& problem) = nullptr;
  int place = kAnyPlace;  ///< in lists, lowest first
};

/// Every flow, one file in integrators/flows each, in the order in which `tripus methods` prints
/// them.
std::span<const Flow> flows();

/// The flow of that name, or null.
inline const Flow* find_flow(std::string_view name) { return find_row(flows(), name); }

}  // namespace tripus::integrators
