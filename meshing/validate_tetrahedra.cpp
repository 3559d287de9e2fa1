#include "meshing/validate_tetrahedra.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/places.hpp"
#include "meshing/predicates.hpp"
#include "topology/components.hpp"

namespace tripus::meshing {
namespace {

using detail::Places;
using topology::Gluings;
using topology::Perm4;

struct SolidFace {
  std::array<std::uint32_t, 3> corners;  ///< sorted
  std::uint32_t place;                   ///< 4 * tetrahedron + face
};

std::string face_name(const SolidFace& face) {
  return "face " + std::to_string(face.corners[0]) + "-" + std::to_string(face.corners[1]) + "-" +
         std::to_string(face.corners[2]);
}

std::vector<SolidFace> sorted_faces(const TetrahedralMesh& mesh) {
  std::vector<SolidFace> faces;
  faces.reserve(4 * mesh.tetrahedra.size());
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (std::uint32_t f = 0; f < 4; ++f) {
      const Tetrahedron& corners = mesh.tetrahedra[t];
      SolidFace face{{corners[(f + 1) % 4], corners[(f + 2) % 4], corners[(f + 3) % 4]}, 4 * t + f};
      std::sort(face.corners.begin(), face.corners.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(), [](const SolidFace& a, const SolidFace& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.place < b.place;
  });
  return faces;
}

/// Vertex i of the tetrahedron with `from` goes to the vertex with the same point; the face with
/// `from`, `to` is shared, so what is left over goes to what is left over.
Perm4 matching(const Tetrahedron& from, const Tetrahedron& to, int face, int other_face) {
  std::array<int, 4> image{};
  for (int i = 0; i < 4; ++i) {
    image[static_cast<std::size_t>(i)] = other_face;
    if (i == face) continue;
    const auto at = std::find(to.begin(), to.end(), from[static_cast<std::size_t>(i)]);
    image[static_cast<std::size_t>(i)] = static_cast<int>(at - to.begin());
  }
  return Perm4::from_images(image[0], image[1], image[2], image[3]);
}

void require_corners(const TetrahedralMesh& mesh, const Places& places) {
  if (mesh.tetrahedra.empty())
    throw InvalidInput("the mesh is empty: it has " + std::to_string(mesh.points.size()) +
                       " points and no tetrahedra");
  if (mesh.tetrahedra.size() > topology::kMaxTetrahedra)
    throw InvalidInput("the mesh has more than 2^28 tetrahedra");
  std::vector<bool> used(mesh.points.size(), false);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Tetrahedron corners = mesh.tetrahedra[t];
    for (const std::uint32_t corner : corners) {
      if (corner >= mesh.points.size())
        throw InvalidInput(places.cell(t) + " has the corner " + std::to_string(corner) +
                           ", but there are only " + std::to_string(mesh.points.size()) +
                           " points, numbered from 0");
      used[corner] = true;
    }
    std::sort(corners.begin(), corners.end());
    const auto twice = std::adjacent_find(corners.begin(), corners.end());
    if (twice != corners.end())
      throw InvalidInput(places.cell(t) + " is degenerate: it has " + places.point(*twice) +
                         " as two of its corners; remove it");
  }
  detail::require_coordinates(mesh.points, places);
  detail::require_points_used(used, places);
  detail::require_points_different(mesh.points, places);
}

void order_corners(TetrahedralMesh& mesh, const Places& places) {
  std::size_t flat = 0, first = 0;
  for (std::size_t t = mesh.tetrahedra.size(); t-- > 0;) {
    Tetrahedron& c = mesh.tetrahedra[t];
    const auto& p = mesh.points;
    const int sign = orientation(p[c[0]], p[c[1]], p[c[2]], p[c[3]]);
    if (sign < 0) std::swap(c[2], c[3]);
    if (sign != 0) continue;
    ++flat;
    first = t;
  }
  if (flat > 0)
    throw InvalidInput(places.cell(first) + " is degenerate: its corners lie in a plane" +
                       detail::in_all(flat) + "; remesh the solid there");
}

void require_different(const TetrahedralMesh& mesh, const Places& places) {
  std::vector<std::array<std::uint32_t, 5>> sorted;
  sorted.reserve(mesh.tetrahedra.size());
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Tetrahedron c = mesh.tetrahedra[t];
    std::sort(c.begin(), c.end());
    sorted.push_back({c[0], c[1], c[2], c[3], t});
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (std::equal(sorted[i].begin(), sorted[i].begin() + 4, sorted[i - 1].begin()))
      throw InvalidInput(places.cell(sorted[i - 1][4]) + " and " + places.cell(sorted[i][4]) +
                         " have the same corners; remove one of them");
}

Gluings glue(const TetrahedralMesh& mesh, const std::vector<SolidFace>& faces,
             const Places& places) {
  Gluings gluings(mesh.tetrahedra.size());
  for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
    while (end < faces.size() && faces[end].corners == faces[i].corners) ++end;
    if (end - i > 2)
      throw InvalidInput(face_name(faces[i]) + " is in " + std::to_string(end - i) +
                         " tetrahedra, the first of them " + places.cell(faces[i].place / 4) +
                         ", " + places.cell(faces[i + 1].place / 4) + ", " +
                         places.cell(faces[i + 2].place / 4) +
                         "; a face may be in two: remove those that overlap");
    if (end - i < 2) continue;
    const std::uint32_t s = faces[i].place, t = faces[i + 1].place;
    gluings.glue(s / 4, static_cast<int>(s % 4), t / 4,
                 matching(mesh.tetrahedra[s / 4], mesh.tetrahedra[t / 4], static_cast<int>(s % 4),
                          static_cast<int>(t % 4)));
  }
  return gluings;
}

/// Positive tetrahedra lie on the two sides of their common face if the gluing is odd.
void require_no_overlap(const Gluings& gluings, const TetrahedralMesh& mesh, const Places& places) {
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) {
      if (gluings.is_open(t, f) || gluings.gluing(t, f).is_odd()) continue;
      const Tetrahedron& c = mesh.tetrahedra[t];
      const auto g = static_cast<std::size_t>(f);
      SolidFace face{{c[(g + 1) % 4], c[(g + 2) % 4], c[(g + 3) % 4]}, 0};
      std::sort(face.corners.begin(), face.corners.end());
      throw InvalidInput(places.cell(t) + " and " + places.cell(gluings.neighbour(t, f)) +
                         " overlap: they lie on the same side of their common " + face_name(face) +
                         "; one of them is inverted: move its points, or remesh the solid there");
    }
}

/// Numbers of tetrahedra, faces and edges at every point: triangles, edges and vertices of its
/// link.
std::vector<std::int64_t> link_characteristics(const TetrahedralMesh& mesh,
                                               const std::vector<SolidFace>& faces) {
  std::vector<std::int64_t> characteristic(mesh.points.size(), 0);
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const std::uint32_t corner : t) ++characteristic[corner];
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i].corners;
    if (i > 0 && faces[i].corners == faces[i - 1].corners) continue;
    for (const std::uint32_t corner : faces[i].corners) --characteristic[corner];
    edges.push_back({a, b});
    edges.push_back({a, c});
    edges.push_back({b, c});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& edge : edges)
    for (const std::uint32_t end : edge) ++characteristic[end];
  return characteristic;
}

struct Boundary {
  std::vector<Triangle> triangles;
  std::vector<SolidFace> faces;  ///< [triangles]
};

Boundary boundary_of(const std::vector<SolidFace>& faces) {
  Boundary boundary;
  for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
    while (end < faces.size() && faces[end].corners == faces[i].corners) ++end;
    if (end - i == 1) boundary.faces.push_back(faces[i]);
  }
  std::sort(boundary.faces.begin(), boundary.faces.end(),
            [](const SolidFace& a, const SolidFace& b) { return a.place < b.place; });
  for (const SolidFace& face : boundary.faces) boundary.triangles.push_back(face.corners);
  return boundary;
}

std::vector<int> genera(const Boundary& boundary, const detail::Connectivity& connectivity,
                        std::size_t point_count) {
  std::vector<std::int64_t> characteristic(connectivity.component_count, 0);
  std::vector<bool> seen(point_count, false);
  std::vector<std::int64_t> triangles(connectivity.component_count, 0);
  for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
    const std::uint32_t c = connectivity.component_of[t];
    ++triangles[c];
    for (const std::uint32_t corner : boundary.triangles[t]) {
      if (!seen[corner]) ++characteristic[c];
      seen[corner] = true;
    }
  }
  std::vector<int> result;
  for (std::size_t c = 0; c < triangles.size(); ++c)
    result.push_back(static_cast<int>((2 - (characteristic[c] - triangles[c] / 2)) / 2));
  std::sort(result.begin(), result.end());
  return result;
}

void require_balls(const TetrahedralMesh& mesh, const std::vector<SolidFace>& faces,
                   const Boundary& boundary, const Places& places) {
  std::vector<bool> outside(mesh.points.size(), false);
  for (const Triangle& t : boundary.triangles)
    for (const std::uint32_t corner : t) outside[corner] = true;
  const auto characteristic = link_characteristics(mesh, faces);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    if (characteristic[p] != (outside[p] ? 1 : 2))
      throw InvalidInput(places.point(p) + " is not manifold: the tetrahedra around it form no " +
                         (outside[p] ? "half-ball" : "ball") +
                         "; separate the parts of the solid that touch there");
}

}  // namespace

Solid require_valid(TetrahedralMesh mesh, const SourceLines& lines) {
  const Places places(lines, "tetrahedron");
  require_corners(mesh, places);
  order_corners(mesh, places);
  require_different(mesh, places);
  const std::vector<SolidFace> faces = sorted_faces(mesh);
  Solid solid;
  solid.gluings = glue(mesh, faces, places);
  require_no_overlap(solid.gluings, mesh, places);
  const Boundary boundary = boundary_of(faces);
  const auto connectivity = detail::require_closed_manifold(
      boundary.triangles, mesh.points.size(),
      [&](std::size_t t) {
        return "the boundary " + face_name(boundary.faces[t]) + " of " +
               places.cell(boundary.faces[t].place / 4);
      },
      places);
  require_balls(mesh, faces, boundary, places);
  if (const auto parts = topology::components(solid.gluings); parts.size() > 1)
    throw InvalidInput("the mesh has " + std::to_string(parts.size()) +
                       " parts that share no face; give each of them in a file of its own");
  solid.boundary_genera = genera(boundary, connectivity, mesh.points.size());
  solid.mesh = std::move(mesh);
  return solid;
}

topology::Gluings gluings_of(const TetrahedralMesh& mesh, const SourceLines& lines) {
  return glue(mesh, sorted_faces(mesh), Places(lines, "tetrahedron"));
}

std::vector<Triangle> boundary_triangles(const TetrahedralMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const SolidFace& face : boundary_of(sorted_faces(mesh)).faces) {
    const Tetrahedron& t = mesh.tetrahedra[face.place / 4];
    const std::size_t f = face.place % 4;
    Triangle corners{t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4]};
    if (f % 2 == 1) std::swap(corners[1], corners[2]);
    triangles.push_back(corners);
  }
  return triangles;
}

}  // namespace tripus::meshing
