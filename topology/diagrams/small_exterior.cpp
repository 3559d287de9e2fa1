#include "topology/diagrams/small_exterior.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "topology/diagrams/exterior.hpp"
#include "topology/simplify/simplify_keeping.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

/// Several short searches find smaller triangulations of small exteriors than a long one does: of
/// the shipped tables' 130 graphs these find what is known to be least. (To stop when four of them
/// agree would save half the time, and lose a tetrahedron of 3 of the 344 exteriors.)
constexpr std::size_t kSmall = 400;
constexpr std::uint64_t kSeeds = 8;
constexpr double kShort = 0.1;

/// E = T + chi/2: with one edge it is the smallest that there is.
bool is_least(const SimplifiedKeeping& found) {
  return found.result.finite_vertices_left == 0 && found.kept.empty() &&
         Triangulation(found.result.gluings).edge_count() == 1;
}

SimplifiedKeeping smallest(const Gluings& gluings, const std::vector<EdgePlace>& kept,
                           const SimplifyOptions& options) {
  if (gluings.tetrahedron_count() > kSmall) return simplify_keeping(gluings, kept, options);
  SimplifyOptions brief = options;
  brief.effort *= kShort;
  SimplifiedKeeping best = simplify_keeping(gluings, kept, brief);
  for (std::uint64_t seed = 1; seed < kSeeds && !best.result.stopped && !is_least(best); ++seed) {
    brief.seed = options.seed + seed;
    SimplifiedKeeping other = simplify_keeping(gluings, kept, brief);
    if (other.result.finite_vertices_left <= best.result.finite_vertices_left &&
        other.result.tetrahedron_count() < best.result.tetrahedron_count())
      best = std::move(other);
  }
  return best;
}

/// "arcs 21 and 22 form a piece of their own, ..." of the smallest piece.
std::string pieces_note(const Diagram& diagram) {
  const DiagramPieces parts = pieces(diagram);
  std::vector<std::vector<std::int64_t>> arcs(parts.count);
  for (Dart d = 0; d < diagram.dart_count(); ++d)
    if (d < diagram.mate(d)) arcs[parts.of_node[diagram.node(d)]].push_back(diagram.arc(d));
  std::vector<std::int64_t> least = *std::ranges::min_element(
      arcs, {}, [](const std::vector<std::int64_t>& piece) { return piece.size(); });
  std::ranges::sort(least);
  constexpr std::size_t kMostShown = 6;
  std::string names;
  for (std::size_t i = 0; i < std::min(kMostShown, least.size()); ++i)
    names += (i == 0 ? "" : i + 1 == least.size() ? " and " : ", ") + std::to_string(least[i]);
  if (least.size() > kMostShown) names += ", ...";
  return (least.size() == 1 ? "arc " + names + " forms" : "arcs " + names + " form") +
         " a piece of " + (least.size() == 1 ? "its" : "their") + " own, one of " +
         std::to_string(parts.count) + " that touch nowhere; the exterior is a connected sum";
}

/// One label a strand: the same given twice is one.
std::vector<DiagramLabel> labels_of_strands(const NamedDiagram& diagram) {
  std::vector<DiagramLabel> labels;
  if (diagram.labels.empty()) return labels;
  const Strands all = strands(diagram.diagram);
  std::map<std::int64_t, std::uint32_t> strand_of_arc;
  for (Dart d = 0; d < diagram.diagram.dart_count(); ++d)
    strand_of_arc.emplace(diagram.diagram.arc(d), all.of_dart[d]);
  std::map<std::uint32_t, const DiagramLabel*> taken;
  for (const DiagramLabel& label : diagram.labels) {
    const auto strand = strand_of_arc.find(label.arc);
    if (strand == strand_of_arc.end())
      throw InvalidInput("there is no arc " + std::to_string(label.arc) +
                         " in the diagram, to which a cone order is given");
    const auto [first, fresh] = taken.emplace(strand->second, &label);
    if (fresh) {
      labels.push_back(label);
    } else if (!(first->second->angle == label.angle)) {
      const auto named = [](const DiagramLabel& each) {
        return std::to_string(each.arc) + " has the cone order " + each.angle.order_text();
      };
      throw InvalidInput("arc " + named(*first->second) + " and arc " + named(label) +
                         ", but they belong to one strand; give one order");
    }
  }
  return labels;
}

}  // namespace

NamedGluings small_exterior(const NamedDiagram& diagram, const SimplifyOptions& options) {
  std::vector<std::int64_t> kept;
  const std::vector<DiagramLabel> labels = labels_of_strands(diagram);
  for (const DiagramLabel& label : labels) kept.push_back(label.arc);
  const DiagramExterior made = exterior(diagram.diagram, kept);
  NamedGluings result{.name = diagram.name, .gluings = {}};
  result.notes = diagram.notes;
  result.orientation_known = diagram.orientation_known;
  if (made.pieces > 1) result.notes.push_back(pieces_note(diagram.diagram));
  // A cone angle of 2 pi is none: the strand is filled in again and need not be an edge.
  std::vector<EdgePlace> edges;
  std::vector<ConeAngle> angles;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (labels[i].angle.is_full()) continue;
    edges.push_back({made.kept[i].tetrahedron, made.kept[i].edge});
    angles.push_back(labels[i].angle);
  }
  SimplifiedKeeping small = smallest(made.gluings, edges, options);
  result.gluings = std::move(small.result.gluings);
  if (edges.empty()) return result;
  const Triangulation triangulation(result.gluings);
  result.cone_angles.resize(triangulation.edge_count());
  for (std::size_t i = 0; i < edges.size(); ++i)
    result.cone_angles[triangulation.edge_class(small.kept[i].tetrahedron, small.kept[i].edge)] =
        angles[i];
  return result;
}

}  // namespace tripus::topology
