#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "base/stop.hpp"
#include "structure/report.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

/// The answers to n triangulations as one table. Numbers are those of the metrics; of what carries
/// none, those of the last iterate, as in a Report.
struct Solutions {
  std::vector<Outcome> outcomes;                       ///< [n]
  std::vector<int> iterations;                         ///< [n] steps of Newton's method
  std::vector<double> volumes;                         ///< [n]
  std::vector<double> max_curvature;                   ///< [n] max|K_e|
  std::vector<std::size_t> edge_start;                 ///< [n + 1] into edge_lengths
  std::vector<std::size_t> tetrahedron_start;          ///< [n + 1] into dihedral_angles
  std::vector<double> edge_lengths;                    ///< of each, [E]
  std::vector<std::array<double, 6>> dihedral_angles;  ///< of each, [T], radians
  /// The whole reports, with certificates, of those that were solved one by one, by their number:
  /// all that are not geometric, and few others.
  std::map<std::size_t, Report> reports;

  std::size_t size() const { return outcomes.size(); }
  std::span<const double> lengths(std::size_t k) const {
    return std::span(edge_lengths).subspan(edge_start[k], edge_start[k + 1] - edge_start[k]);
  }
  std::span<const std::array<double, 6>> angles(std::size_t k) const {
    return std::span(dihedral_angles)
        .subspan(tetrahedron_start[k], tetrahedron_start[k + 1] - tetrahedron_start[k]);
  }
};

/// Many small triangulations at once: as `solve` with its default options answers each of them, to
/// rounding, but several times as quickly where metrics are found. Triangulations of up to eight
/// tetrahedra and compact boundary are solved eight at a time, one to each lane of the vector
/// registers that this processor has; the rest, and where no metric is found so, one by one. An
/// answer depends neither on the others nor on the instruction set. One thread.
///
/// Throws InvalidInput as `solve` does. When stopped, what has no answer yet is unresolved, with
/// zeros for its numbers.
Solutions solve_all(std::span<const topology::Triangulation> triangulations, const Stop& stop = {});

}  // namespace tripus::structure
