#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "structure/detail/angle_constraints.hpp"
#include "topology/triangulation.hpp"

struct glp_prob;

namespace tripus::structure::detail {

/// Up to how many tetrahedra an outcome waits for the exact decision, which takes seconds beyond: it
/// took 23 s at 10,000, 8 s at half of them. Without GLPK (the module for browsers) fewer: what
/// decides there is a dense table, and throws Unsupported beyond.
std::size_t most_tetrahedra_decided();

/// The linear programme of the widest margin (docs/theory.md (50)), in units of pi:
///     max m:  angle_c >= m,  vertex sums <= 1 - m (= 1 at ideal vertices),  edge sums = cone
///     angles.
/// It always has an optimum. GLPK does the work and stays inside; programmes of
/// one thread must be destroyed in the reverse of the order in which they were made.
class AngleProgramme {
 public:
  ///   cone_angles [E]; empty for 2 pi
  explicit AngleProgramme(const topology::Triangulation& triangulation,
                          std::span<const topology::ConeAngle> cone_angles = {});
  ~AngleProgramme();
  AngleProgramme(const AngleProgramme&) = delete;
  AngleProgramme& operator=(const AngleProgramme&) = delete;

  /// From now on; then both methods below give up. Infinite by default.
  void limit_time(double seconds);
  bool is_out_of_time() const { return Clock::now() >= deadline_; }

  /// The simplex method in floating point; false if it fails.
  bool solve();
  /// The simplex method in rational arithmetic, from the basis of the last `solve`; false if it
  /// fails. The basis is then optimal; the numbers below are its, rounded.
  bool solve_exactly();

  double margin() const;
  std::vector<double> angles() const;              ///< [T x 6] units of pi
  std::vector<double> vertex_multipliers() const;  ///< [T x 4] w_v, >= 0 but for rounding

  /// What determines the numbers exactly: the rows that hold with equality, by nonbasic status, and
  /// the columns not at 0. Rows are edge classes 0..E-1, then tetrahedron vertices E + 4 t + v;
  /// columns are corners 6 t + e (angle - m), then the margin 6 T. As many rows as columns.
  struct Basis {
    std::vector<std::size_t> rows;
    std::vector<std::size_t> columns;
  };
  Basis basis() const;

  const AngleConstraints& constraints() const { return constraints_; }

 private:
  using Clock = std::chrono::steady_clock;
  int milliseconds_left() const;

  void add_columns();
  void add_rows(const topology::Triangulation& triangulation);

  std::unique_lock<std::mutex> lock_;  // held where GLPK has one environment for all threads
  bool owns_environment_;              // GLPK had none in this thread: it goes with the programme
  int old_term_out_;
  const AngleConstraints constraints_;
  std::size_t corner_count_;  // 6 T
  std::size_t edge_count_;
  glp_prob* programme_;
  Clock::time_point deadline_ = Clock::time_point::max();
};

}  // namespace tripus::structure::detail
