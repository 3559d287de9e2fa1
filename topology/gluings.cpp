#include "topology/gluings.hpp"

#include <string>

#include "base/error.hpp"
#include "topology/work_size.hpp"

namespace tripus::topology {
namespace {

std::string face_name(std::size_t t, int f) {
  return "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t);
}

std::string text(Perm4 p) {
  const auto letters = word(p);
  return {letters.begin(), letters.end()};
}

[[noreturn]] void refuse_one_sided(const Gluings& gluings, std::size_t t, int f) {
  const std::size_t other = gluings.neighbour(t, f);
  const Perm4 p = gluings.gluing(t, f);
  std::string back = "is open";
  if (!gluings.is_open(other, p(f)))
    back = "is glued to tetrahedron " + std::to_string(gluings.neighbour(other, p(f))) + " by " +
           text(gluings.gluing(other, p(f)));
  throw InvalidInput(face_name(t, f) + " is glued to tetrahedron " + std::to_string(other) +
                     " by " + text(p) + ", but " + face_name(other, p(f)) + " " + back +
                     "; expected tetrahedron " + std::to_string(t) + " by " + text(p.inverse()));
}

}  // namespace

void require_consistent(const Gluings& gluings, OpenFaces open_faces) {
  const std::size_t count = gluings.tetrahedron_count();
  note_work_size(count);
  if (count > kMaxTetrahedra)
    throw InvalidInput(std::to_string(count) + " tetrahedra are more than the " +
                       std::to_string(kMaxTetrahedra) + " that a triangulation can have");
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f) {
      if (gluings.is_open(t, f)) {
        if (open_faces == OpenFaces::kAllowed) continue;
        throw InvalidInput(face_name(t, f) +
                           " is open; every face must be glued to another (double the "
                           "triangulation or cone its boundary first)");
      }
      const std::size_t other = gluings.neighbour(t, f);
      const Perm4 p = gluings.gluing(t, f);
      if (other >= count)
        throw InvalidInput(face_name(t, f) + " is glued to tetrahedron " + std::to_string(other) +
                           ", which does not exist; there are " + std::to_string(count) +
                           " tetrahedra, numbered from 0");
      if (other == t && p(f) == f)
        throw InvalidInput(face_name(t, f) + " is glued to itself (by " + text(p) + ")");
      if (gluings.neighbour(other, p(f)) != t || gluings.gluing(other, p(f)) != p.inverse())
        refuse_one_sided(gluings, t, f);
    }
}

}  // namespace tripus::topology
