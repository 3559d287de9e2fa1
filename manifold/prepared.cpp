#include "manifold/prepared.hpp"

#include <fmt/format.h>

#include "base/stop.hpp"

namespace tripus {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

void make_ideal(topology::NamedGluings& loaded, topology::FiniteVertices finite_vertices,
                const Stop& stop) {
  topology::IdealTriangulation ideal = topology::ideal_triangulation(
      loaded.gluings,
      loaded.cone_angles.empty() ? finite_vertices : topology::FiniteVertices::kKeep, stop);
  if (!ideal.is_changed()) return;
  std::string what;
  if (ideal.coned_faces > 0)
    what = fmt::format(
        "the boundary of {} was coned off, each component of it to a vertex (a "
        "sphere is filled in)",
        counted(ideal.coned_faces, "open face", "open faces"));
  if (ideal.finite_vertices > 0) {
    what +=
        fmt::format("{}{} removed by simplifying", what.empty() ? "" : "; ",
                    counted(ideal.finite_vertices, "finite vertex was", "finite vertices were"));
  }
  loaded.notes.push_back(fmt::format("{}: {} became {}", what,
                                     counted(ideal.given, "tetrahedron", "tetrahedra"),
                                     ideal.gluings.tetrahedron_count()));
  loaded.gluings = std::move(ideal.gluings);
}

}  // namespace tripus
