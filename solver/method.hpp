#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/registry.hpp"
#include "solver/problem.hpp"

namespace tripus::solver {

/// Why an iteration stopped. It says nothing about what was found: the caller judges that.
enum class Termination {
  kConverged,         ///< max|gradient| <= tolerance
  kIterationLimit,    ///< Options::max_iterations reached
  kTimeLimit,         ///< Options::time_limit reached
  kStalled,           ///< no further decrease possible in floating point
  kUnbounded,         ///< the iterates run away: no minimiser in sight
  kNumericalFailure,  ///< a factorisation or an evaluation failed
  kInterrupted,       ///< the observer asked to stop
};

/// The termination in words, for messages: "converged", "reached the iteration limit", ...
std::string_view to_string(Termination termination);

/// One line of a run's history; passed to the observer at the start (iteration 0) and after every
/// accepted step.
struct Iterate {
  int iteration = 0;
  int evaluations = 0;        ///< of the gradient so far
  double seconds = 0;         ///< since the start
  double max_gradient = 0;    ///< max|gradient| at x
  double time = 0;            ///< flow time t, integrators only
  std::span<const double> x;  ///< [n]
};

/// Return false to stop the run.
using Observer = std::function<bool(const Iterate&)>;

struct Options {
  double tolerance = 1e-12;                                     ///< on max|gradient|; finite, > 0
  int max_iterations = 0;                                       ///< 0: the method's own default
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds, > 0
  Observer observer;                                            ///< may be empty
};

struct Summary {
  Termination termination = Termination::kNumericalFailure;
  std::string message;  ///< a sentence of detail, may be empty
  int iterations = 0;
  int evaluations = 0;         ///< of the gradient
  long linear_iterations = 0;  ///< conjugate-gradient iterations, where the method has any
  double seconds = 0;
  double max_gradient = 0;  ///< at the returned x
};

/// Throws InvalidInput, naming the option and its value, if an option is outside its domain.
void validate(const Options& options);

/// Minimises from x [n], in place. Every mathematical outcome is returned, never thrown; x is
/// finite afterwards if it was before, and is the point with the least max|gradient| that was
/// accepted. Throws InvalidInput for a bad option or a length of x other than n; what the problem
/// or the observer throw passes through.
using Minimise = Summary (*)(const Problem& problem, std::span<double> x, const Options& options);

/// One line of the table of methods.
struct Method {
  std::string_view name;         ///< as typed after --method
  std::string_view description;  ///< one line for `tripus methods`
  bool second_order = false;     ///< uses second derivatives and converges to full accuracy fast
  Minimise minimise = nullptr;
  int place = kAnyPlace;  ///< in lists, lowest first
};

/// Every minimiser, one file in solver/methods each, in the order in which `tripus methods` prints
/// them.
std::span<const Method> methods();

/// The method of that name, or null.
inline const Method* find_method(std::string_view name) { return find_row(methods(), name); }

}  // namespace tripus::solver
