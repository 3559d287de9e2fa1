#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/function.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>
#include <tripus/tripus.hpp>

#include "python/src/arrays.hpp"
#include "python/src/bindings.hpp"
#include "structure/closed_bigon.hpp"
#include "topology/isomorphism.hpp"
#include "topology/labelled_isosig.hpp"
#include "topology/orientation.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::python {
namespace {

using topology::Gluings;
using topology::Perm4;

using NeighbourArray = nb::ndarray<const std::uint32_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using PermArray = nb::ndarray<const std::uint8_t, nb::ndim<3>, nb::c_contig, nb::device::cpu>;

/// [T x 4] and [T x 4 x 4] images; checked as a file's content is.
Gluings gluings_of(const NeighbourArray& neighbours, const PermArray& perms) {
  const std::size_t count = neighbours.shape(0);
  if (neighbours.shape(1) != 4 || perms.shape(0) != count || perms.shape(1) != 4 ||
      perms.shape(2) != 4)
    throw InvalidInput("gluings are an array [T x 4] of tetrahedra and one [T x 4 x 4] of images");
  Gluings gluings(count);
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f) {
      const std::uint8_t* p = perms.data() + 16 * t + std::size_t(4 * f);
      unsigned seen = 0;
      for (int i = 0; i < 4; ++i) seen |= p[i] < 4 ? 1u << p[i] : 0u;
      if (seen != 15u)
        throw InvalidInput("face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) +
                           ": its four images are no permutation of 0, 1, 2, 3");
      gluings.set_one_side(t, f, neighbours.data()[4 * t + std::size_t(f)],
                           Perm4::from_images(p[0], p[1], p[2], p[3]));
    }
  topology::require_consistent(gluings, topology::OpenFaces::kRefused);
  return gluings;
}

Manifold from_arrays(const NeighbourArray& neighbours, const PermArray& perms,
                     const nb::bytes& name, const nb::bytes& input, bool orientation_known,
                     const nb::list& cone_angles) {
  const std::vector<topology::ConeAngle> angles = read_cone_angles(cone_angles);
  std::string called = as_string(name), typed = as_string(input);
  return run({}, [&](const Context&) {
    topology::NamedGluings given{called, gluings_of(neighbours, perms)};
    given.orientation_known = orientation_known;
    given.cone_angles = angles;
    return Manifold(std::move(given), typed);
  });
}

nb::tuple arrays_of(const Manifold& manifold) {
  const Gluings& gluings = manifold.triangulation().gluings();
  const std::size_t count = gluings.tetrahedron_count();
  std::vector<std::uint32_t> neighbours;
  std::vector<std::uint8_t> images;
  neighbours.reserve(4 * count);
  images.reserve(16 * count);
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f) {
      neighbours.push_back(gluings.neighbour(t, f));
      const Perm4 p = gluings.gluing(t, f);
      for (int i = 0; i < 4; ++i) images.push_back(std::uint8_t(p(i)));
    }
  return nb::make_tuple(owned(std::move(neighbours), {count, 4}),
                        owned(std::move(images), {count, 4, 4}));
}

/// (Euler characteristic, orientable, kind, number of triangles) of each vertex class.
nb::list links_of(const Manifold& manifold) {
  nb::list result;
  const auto orbifold = topology::orbifold_links(manifold.triangulation(), manifold.cone_angles());
  const auto links = manifold.links();
  for (std::size_t v = 0; v < links.size(); ++v)
    result.append(nb::make_tuple(links[v].euler_characteristic, links[v].orientable,
                                 std::string(topology::to_string(orbifold[v].kind)),
                                 links[v].triangle_count, orbifold[v].cone_points));
  return result;
}

nb::tuple presentation_tuple(const topology::Presentation& presentation) {
  return nb::make_tuple(presentation.generator_count, presentation.relators);
}

/// Generators, relators and face letters; then the reduced presentation.
nb::tuple group_of(const Manifold& manifold) {
  const auto [group, small] = quickly([&] {
    topology::FundamentalGroup found = manifold.fundamental_group();
    topology::ReducedPresentation reduced = topology::reduced(found.presentation);
    return std::pair(std::move(found), std::move(reduced));
  });
  nb::list solved;
  for (const auto& definition : small.solved)
    solved.append(nb::make_tuple(definition.generator, definition.word));
  const std::size_t count = manifold.tetrahedron_count();
  return nb::make_tuple(presentation_tuple(group.presentation),
                        owned(std::vector<topology::Letter>(group.face_letters), {count, 4}),
                        presentation_tuple(small.presentation), small.kept, solved);
}

std::vector<topology::ConeAngle> labels_of(const Manifold& manifold) {
  return topology::completed(manifold.cone_angles(), manifold.triangulation().edge_count());
}

bool keeps_labels(const Manifold& from, const topology::Isomorphism& isomorphism,
                  const Manifold& to) {
  const auto carried = topology::relabelled_edges(from.triangulation(), labels_of(from),
                                                  isomorphism, to.triangulation());
  return carried == labels_of(to);
}

/// All isomorphisms that keep the cone angles: images of tetrahedra [n x T] and of their vertices
/// [n x T x 4].
nb::tuple isomorphisms_of(const Manifold& from, const Manifold& to, const Limits& limits) {
  struct Found {
    std::size_t count = 0;
    std::vector<std::uint32_t> tetrahedra;
    std::vector<std::uint8_t> vertices;
  };
  Found found = run(limits, [&](const Context& context) {
    Found made;
    for (const auto& each : topology::all_isomorphisms(
             from.triangulation().gluings(), to.triangulation().gluings(), context.stop)) {
      if (!keeps_labels(from, each, to)) continue;
      ++made.count;
      const auto& images = each.tetrahedron_images;
      made.tetrahedra.insert(made.tetrahedra.end(), images.begin(), images.end());
      for (const Perm4 p : each.perms)
        for (int i = 0; i < 4; ++i) made.vertices.push_back(std::uint8_t(p(i)));
    }
    return made;
  });
  const std::size_t count = from.tetrahedron_count();
  return nb::make_tuple(owned(std::move(found.tetrahedra), {found.count, count}),
                        owned(std::move(found.vertices), {found.count, count, 4}));
}

/// Whether there is an isomorphism that keeps the cone angles.
bool is_isomorphic_to(const Manifold& from, const Manifold& to) {
  return run({}, [&](const Context& context) {
    const auto &a = from.triangulation().gluings(), &b = to.triangulation().gluings();
    if (topology::all_full(from.cone_angles()) && topology::all_full(to.cone_angles()))
      return topology::is_isomorphic(a, b);
    if (!from.triangulation().is_connected() || !to.triangulation().is_connected()) return false;
    const auto all = topology::all_isomorphisms(a, b, context.stop);
    return std::ranges::any_of(all, [&](const auto& each) { return keeps_labels(from, each, to); });
  });
}

/// A manifold with other labels of its vertices and tetrahedra, its cone angles carried along.
Manifold relabelled(const Manifold& manifold, const topology::Isomorphism& isomorphism,
                    bool orientation_known) {
  topology::NamedGluings made{
      manifold.name(), topology::relabelled(manifold.triangulation().gluings(), isomorphism)};
  made.orientation_known = orientation_known;
  if (!manifold.cone_angles().empty())
    made.cone_angles =
        topology::relabelled_edges(manifold.triangulation(), manifold.cone_angles(), isomorphism,
                                   topology::Triangulation(made.gluings));
  return Manifold(std::move(made));
}

/// Tetrahedra stay, and their labels 2 and 3 are exchanged where `turned` says so.
topology::Isomorphism turning(const std::vector<char>& turned) {
  topology::Isomorphism in_place;
  for (std::size_t t = 0; t < turned.size(); ++t) {
    in_place.tetrahedron_images.push_back(topology::TetrahedronIndex(t));
    in_place.perms.push_back(turned[t] ? Perm4::from_images(0, 1, 3, 2) : Perm4());
  }
  return in_place;
}

Manifold oriented(const Manifold& manifold) {
  const auto disagreeing = topology::disagreeing_labels(manifold.triangulation().gluings());
  if (!disagreeing) return manifold;
  return relabelled(manifold, turning(*disagreeing), true);
}

/// (numerator, denominator, radians) of each cone angle: exact where the denominator is not 0.
nb::list cone_angles_of(const Manifold& manifold) {
  nb::list result;
  for (const topology::ConeAngle& k : manifold.cone_angles())
    result.append(
        nb::make_tuple(k.numerator(), k.is_rational() ? k.denominator() : 0, k.radians()));
  return result;
}

}  // namespace

std::vector<topology::ConeAngle> read_cone_angles(const nb::list& given) {
  std::vector<topology::ConeAngle> angles;
  for (const nb::handle each : given) {
    if (nb::isinstance<nb::str>(each)) {
      angles.push_back(topology::parse_cone_order(nb::cast<std::string>(each)));
    } else if (nb::isinstance<nb::tuple>(each)) {
      const auto [numerator, denominator] = nb::cast<std::pair<std::int64_t, std::int64_t>>(each);
      angles.push_back(topology::ConeAngle::rational(numerator, denominator));
    } else {
      angles.emplace_back(nb::cast<double>(each));
    }
  }
  return angles;
}

void bind_topology(nb::class_<Manifold>& type) {
  type.def("arrays", arrays_of)
      .def("name", [](const Manifold& m) { return as_bytes(m.name()); })
      .def("input", [](const Manifold& m) { return as_bytes(m.input()); })
      .def("label", [](const Manifold& m) { return as_bytes(quickly([&] { return m.label(); })); })
      .def("is_orientation_known", &Manifold::is_orientation_known)
      .def("tetrahedron_count", &Manifold::tetrahedron_count)
      .def("edge_count", [](const Manifold& m) { return m.triangulation().edge_count(); })
      .def("vertex_count", [](const Manifold& m) { return m.triangulation().vertex_count(); })
      .def("component_count", [](const Manifold& m) { return m.triangulation().component_count(); })
      .def("is_orientable", &Manifold::is_orientable)
      .def("valences",
           [](const Manifold& m) {
             std::vector<std::size_t> valences;
             for (std::size_t e = 0; e < m.triangulation().edge_count(); ++e)
               valences.push_back(m.triangulation().valence(e));
             return valences;
           })
      .def("edge_classes",
           [](nb::handle_t<Manifold> self) {
             const auto& m = nb::cast<const Manifold&>(self).triangulation();
             return view(m.edge_classes().data(), {m.tetrahedron_count(), 6}, self);
           })
      .def("vertex_classes",
           [](nb::handle_t<Manifold> self) {
             const auto& m = nb::cast<const Manifold&>(self).triangulation();
             return view(m.vertex_classes().data(), {m.tetrahedron_count(), 4}, self);
           })
      .def("links", links_of)
      .def("signature", [](const Manifold& m) { return quickly([&] { return m.signature(); }); })
      .def("oriented_signature",
           [](const Manifold& m) { return quickly([&] { return m.oriented_signature(); }); })
      .def("homology",
           [](const Manifold& m) {
             const topology::AbelianGroup group =
                 run({}, [&](const Context& c) { return m.homology(c); });
             return nb::make_tuple(group.rank, group.invariant_factors);
           })
      .def("fundamental_group", group_of)
      .def("isomorphisms_to", isomorphisms_of)
      .def("is_isomorphic_to", is_isomorphic_to)
      .def("cone_angles", cone_angles_of)
      .def("closed_bigon",
           [](const Manifold& m) -> std::optional<nb::dict> {
             const auto bigon = run(
                 {}, [&](const Context&) { return structure::closed_bigon(m.triangulation()); });
             if (!bigon) return std::nullopt;
             return as_dict(*bigon);
           })
      .def("is_labelled", [](const Manifold& m) { return !topology::all_full(m.cone_angles()); })
      .def("with_cone_angles",
           [](const Manifold& m, const nb::list& angles) {
             auto given = read_cone_angles(angles);
             return quickly([&] { return m.with_cone_angles(std::move(given)); });
           })
      .def("mirrored",
           [](const Manifold& m) {
             return quickly([&] {
               const std::vector<char> all(m.tetrahedron_count(), 1);
               return relabelled(m, turning(all), m.is_orientation_known());
             });
           })
      .def("oriented", [](const Manifold& m) { return quickly([&] { return oriented(m); }); })
      .def("relabelled",
           [](const Manifold& m, std::uint64_t seed) {
             return quickly([&] {
               const auto random = topology::random_isomorphism(m.tetrahedron_count(), seed);
               return relabelled(m, random, false);  // the mirror image, perhaps
             });
           })
      .def("simplified",
           [](const Manifold& m, std::uint64_t seed, double effort, const Limits& limits) {
             topology::SimplifyOptions options;
             options.seed = seed;
             options.effort = effort;
             return run(limits, [&](const Context& c) { return m.simplified(options, c); });
           })
      .def("drilled",
           [](const Manifold& m, const std::vector<std::size_t>& edges, std::uint64_t seed,
              const Limits& limits) {
             topology::SimplifyOptions options;
             options.seed = seed;
             return run(limits, [&](const Context& c) { return m.drilled(edges, options, c); });
           })
      .def("cover", [](const Manifold& m, const std::vector<std::vector<std::uint32_t>>& images,
                       const Limits& limits) {
        return run(limits, [&](const Context& c) { return m.cover(images, c); });
      });
}

void bind_arrays(nb::module_& module) { module.def("from_arrays", from_arrays); }

}  // namespace tripus::python
