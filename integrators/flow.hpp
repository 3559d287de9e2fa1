#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "base/registry.hpp"
#include "solver/problem.hpp"
#include "solver/run.hpp"

namespace tripus::integrators {

/// A vector field dx/dt = F(x) made from the gradient g and the Hessian H of a Problem, whose zeros
/// are those of g.
class Field {
 public:
  virtual ~Field() = default;

  /// Writes F(x) into velocity [n], g(x) into gradient [n] and max|g|. Returns false where F is not
  /// defined or not finite. Counts in `run`.
  virtual bool evaluate(solver::Run& run, std::span<const double> x, std::span<double> velocity,
                        std::span<double> gradient, double& max_gradient) = 0;

  /// Jv = -(dF/dx) v, or its leading part near a zero of g, at the point of the latest evaluation
  /// of the Problem with second derivatives, which is x. [n] each. g is the gradient there.
  virtual void jacobian_times(std::span<const double> x, std::span<const double> g,
                              std::span<const double> v, std::span<double> Jv) = 0;

  /// A step that need not be exceeded, whatever the stability limit.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }

  /// Whether |g| (Euclidean) decreases along every trajectory where the problem is convex.
  virtual bool contractive() const { return true; }
};

/// One line of the table of flows.
struct Flow {
  std::string_view name;         ///< as typed after --method flow:
  std::string_view description;  ///< one line for `tripus methods`
  std::unique_ptr<Field> (*make)(solver::Problem& problem) = nullptr;
  int place = kAnyPlace;  ///< in lists, lowest first
};

/// Every flow, one file in integrators/flows each, in the order in which `tripus methods` prints
/// them.
std::span<const Flow> flows();

/// The flow of that name, or null.
inline const Flow* find_flow(std::string_view name) { return find_row(flows(), name); }

}  // namespace tripus::integrators
