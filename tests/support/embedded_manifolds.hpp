#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "embedding/embedding.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cone_angle.hpp"
#include "topology/isosig.hpp"

/// Metrics in space, for the tests of embedding/.
namespace tripus::testing {

struct Embedded {
  topology::Triangulation triangulation;
  structure::Report report;
  embedding::Embedding embedding;
};

/// Nothing where the triangulation carries no metric, or is outside the domain of solve.
inline std::optional<Embedded> try_embed(topology::Triangulation triangulation,
                                         const std::vector<topology::ConeAngle>& cone_angles = {}) {
  structure::SolveOptions options;
  options.evidence = false;
  options.cone_angles = cone_angles;
  structure::Report report = structure::solve(triangulation, options);
  if (report.outcome != structure::Outcome::kGeometric) return std::nullopt;
  embedding::Embedding embedding =
      embedding::embed(triangulation, report.edge_lengths, {cone_angles, 0});
  return Embedded{std::move(triangulation), std::move(report), std::move(embedding)};
}
inline std::optional<Embedded> try_embed(const std::string& isosig) {
  return try_embed(topology::Triangulation(topology::decode_isosig(isosig)));
}

/// "SIGNATURE" or "SIGNATURE E=0", where edge class E is parabolic.
inline std::optional<Embedded> try_embed_parabolic(const std::string& text) {
  const std::size_t blank = text.find(' ');
  topology::Triangulation triangulation(topology::decode_isosig(text.substr(0, blank)));
  std::vector<topology::ConeAngle> cone_angles;
  if (blank != std::string::npos) {
    cone_angles.resize(triangulation.edge_count());
    cone_angles.at(std::stoul(text.substr(blank + 1))) = topology::ConeAngle::rational(0, 1);
  }
  return try_embed(std::move(triangulation), cone_angles);
}

/// Manifolds with a parabolic edge: all six of a tetrahedron or some, cusps beside it or geodesic
/// boundary alone, orientable and not.
inline constexpr const char* kParabolic[] = {
    "cPcbbbihq 0=0",   "cPcbbbiht 0=0",   "cPcbbbiht 1=0",   "dLQbcccherw 0=0", "dLQbcccherw 1=0",
    "dLQabccjkjn 0=0", "dLQacccjjkg 0=0", "dLQbccchrqg 1=0", "bkaaid 0=0",      "cPcbbbdhq 0=0"};

inline Embedded embedded_tripus() { return *try_embed("cPcbbbihq"); }

/// Non-orientable manifolds with orientable boundary; the lists of data/ are all orientable.
inline constexpr const char* kNonOrientable[] = {"dLQbccchrqg", "eLPkbcdddjjvkx", "eLMkbcddddlnar",
                                                 "eLPkbcdddmhdpu", "eLPkbcddddqlfs"};

/// Every geometric triangulation of data/triangulations-2.txt and -3.txt, every `step`-th line of
/// -4.txt, and the non-orientable ones: visit(signature, Embedded, whether of the list of 4).
template <class Visit>
void for_geometric_triangulations(std::size_t step, Visit visit) {
  for (const char* name : kNonOrientable) visit(name, try_embed(name).value(), false);
  for (const char* file :
       {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"}) {
    const auto lines = data_lines(file);
    const bool large = std::string(file).find('4') != std::string::npos;
    for (std::size_t n = 0; n < lines.size(); n += large ? step : 1) {
      const std::optional<Embedded> embedded = try_embed(lines[n]);
      if (embedded) visit(lines[n], *embedded, large);
    }
  }
}

}  // namespace tripus::testing
