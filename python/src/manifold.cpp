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
#include "structure/method.hpp"
#include "topology/isomorphism.hpp"
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
                     const nb::bytes& name, const nb::bytes& input, bool orientation_known) {
  topology::NamedGluings given{as_string(name), gluings_of(neighbours, perms)};
  given.orientation_known = orientation_known;
  return Manifold(std::move(given), as_string(input));
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
  const auto orbifold = topology::orbifold_links(manifold.triangulation());
  const auto links = manifold.links();
  for (std::size_t v = 0; v < links.size(); ++v)
    result.append(nb::make_tuple(links[v].euler_characteristic, links[v].orientable,
                                 std::string(topology::to_string(orbifold[v].kind)),
                                 links[v].triangle_count));
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

Manifold cover_of(const Manifold& base, const std::vector<std::vector<std::uint32_t>>& images) {
  const topology::FundamentalGroup group = base.fundamental_group();
  const std::size_t count = group.presentation.generator_count;
  if (images.size() != count)
    throw InvalidInput("a cover is given by a permutation for each of the " +
                       std::to_string(count) + " generators, not by " +
                       std::to_string(images.size()));
  topology::TransitiveAction action;
  action.degree = images.empty() ? 1 : images.front().size();
  action.images = images;
  for (std::size_t g = 0; g < count; ++g) {
    std::vector<bool> seen(action.degree);
    for (const std::uint32_t sheet : images[g])
      if (sheet < action.degree) seen[sheet] = true;
    if (images[g].size() != action.degree || std::ranges::count(seen, true) != long(action.degree))
      throw InvalidInput("generator " + std::to_string(g) + " is given no permutation of 0 to " +
                         std::to_string(action.degree - 1));
  }
  for (std::size_t r = 0; r < group.presentation.relators.size(); ++r)
    for (std::uint32_t start = 0; start < action.degree; ++start) {
      std::uint32_t sheet = start;
      for (const topology::Letter letter : group.presentation.relators[r]) {
        const auto& image = images[topology::generator_of(letter)];
        sheet = letter > 0 ? image[sheet]
                           : std::uint32_t(std::ranges::find(image, sheet) - image.begin());
      }
      if (sheet != start)
        throw InvalidInput("the permutations are no action: relator " + std::to_string(r) +
                           " moves sheet " + std::to_string(start));
    }
  Manifold cover(topology::cover_of_action(base.triangulation().gluings(), group, action));
  if (!cover.triangulation().is_connected())
    throw InvalidInput("the permutations do not join all sheets: the cover is not connected");
  return cover;
}

/// The options that Python has in a dict, each checked by solve itself.
structure::SolveOptions solve_options(const nb::dict& given,
                                      std::vector<structure::HistoryRow>* history) {
  structure::SolveOptions options;
  const auto take = [&](const char* key, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if (given.contains(key)) value = nb::cast<Value>(given[key]);
  };
  take("method", options.method);
  take("initial_lengths", options.initial_lengths);
  take("initial_length", options.initial_length);
  take("tolerance", options.tolerance);
  take("max_iterations", options.max_iterations);
  take("evidence", options.evidence);
  take("angle_structure", options.angle_structure);
  if (given.contains("cone_angles"))
    for (const nb::handle each : nb::cast<nb::list>(given["cone_angles"])) {
      // A text is a cone order, a number an angle.
      options.cone_angles.push_back(nb::isinstance<nb::str>(each)
                                        ? topology::parse_cone_order(nb::cast<std::string>(each))
                                        : topology::ConeAngle(nb::cast<double>(each)));
    }
  if (given.contains("history"))
    options.history = [history](const structure::HistoryRow& row) { history->push_back(row); };
  return options;
}

Array<double> history_array(const std::vector<structure::HistoryRow>& history) {
  std::vector<double> rows;
  for (const auto& row : history)
    rows.insert(rows.end(),
                {double(row.iteration), double(row.evaluations), row.seconds, row.max_curvature,
                 row.energy, row.volume, row.shortest_edge, row.longest_edge});
  return owned(std::move(rows), {history.size(), 8});
}

nb::tuple solve(const Manifold& manifold, const nb::dict& given, const Limits& limits) {
  std::vector<structure::HistoryRow> history;
  const structure::SolveOptions options = solve_options(given, &history);
  structure::Report report = run(limits, [&](const Context& context) {
    history.clear();
    return manifold.solve(options, context);
  });
  return nb::make_tuple(as_dict(report), history_array(history));
}

/// The isomorphism as (tetrahedron images, vertex images), or None.
nb::object isomorphism_of(const Manifold& from, const Manifold& to) {
  const auto found = quickly([&] {
    return topology::find_isomorphism(from.triangulation().gluings(), to.triangulation().gluings());
  });
  if (!found) return nb::none();
  std::vector<std::array<int, 4>> perms;
  for (const Perm4 p : found->perms) perms.push_back({p(0), p(1), p(2), p(3)});
  return nb::make_tuple(found->tetrahedron_images, perms);
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
             const topology::AbelianGroup group = quickly([&] { return m.homology(); });
             return nb::make_tuple(group.rank, group.invariant_factors);
           })
      .def("fundamental_group", group_of)
      .def("isomorphism_to", isomorphism_of)
      .def("mirrored",
           [](const Manifold& m) {
             return Manifold(topology::mirrored(m.triangulation().gluings()), m.name());
           })
      .def("oriented",
           [](const Manifold& m) {
             return Manifold(topology::oriented(m.triangulation().gluings()), m.name());
           })
      .def("relabelled",
           [](const Manifold& m, std::uint64_t seed) {
             return Manifold(topology::random_relabelling(m.triangulation().gluings(), seed),
                             m.name());
           })
      .def("simplified",
           [](const Manifold& m, std::uint64_t seed, double effort, const Limits& limits) {
             topology::SimplifyOptions options;
             options.seed = seed;
             options.effort = effort;
             return run(limits, [&](const Context& c) { return m.simplified(options, c); });
           })
      .def("cover", [](const Manifold& m, const std::vector<std::vector<std::uint32_t>>& images) {
        return cover_of(m, images);
      });
}

void bind_metric_questions(nb::class_<Manifold>& type) {
  type.def("covers",
           [](const Manifold& m, std::size_t degree, const Limits& limits) {
             return run(limits, [&](const Context& c) { return m.covers(degree, c); });
           })
      .def("cyclic_covers",
           [](const Manifold& m, std::size_t degree, const Limits& limits) {
             return run(limits, [&](const Context& c) { return m.cyclic_covers(degree, c); });
           })
      .def("verdict",
           [](const Manifold& m, const Limits& limits) {
             return as_dict(*run(limits, [&](const Context& c) { return &m.verdict(c); }));
           })
      .def("volume",
           [](const Manifold& m) -> std::optional<double> {
             const Metric* metric = run({}, [&](const Context& c) { return m.metric(c); });
             if (metric == nullptr) return std::nullopt;
             return metric->volume();
           })
      .def("outcome",
           [](const Manifold& m) {
             return std::string(structure::to_string(
                 run({}, [&](const Context& c) { return m.verdict(c).outcome; })));
           })
      .def("solve", solve)
      .def("retriangulated",
           [](const Manifold& m, std::uint64_t seed, std::size_t budget, std::size_t extra,
              const Limits& limits) {
             return run(limits, [&](const Context& c) {
               return m.retriangulated({seed, budget, extra}, c);
             });
           })
      .def("to_json",
           [](const Manifold& m, const Limits& limits) {
             return run(limits, [&](const Context& c) { return m.to_json(c); });
           })
      .def("write", [](const Manifold& m, const nb::bytes& path, const Limits& limits) {
        run(limits, [&](const Context& c) { return m.write(as_string(path), c), true; });
      });
}

}  // namespace

nb::dict as_dict(const structure::Report& report) {
  nb::dict d;
  d["outcome"] = std::string(structure::to_string(report.outcome));
  d["message"] = report.message;
  d["advice"] = std::string(structure::to_string(report.advice));
  d["termination"] = std::string(solver::to_string(report.termination));
  d["method"] = report.method;
  d["iterations"] = report.iterations;
  d["evaluations"] = report.evaluations;
  d["seconds"] = report.seconds;
  d["max_curvature"] = report.max_curvature;
  d["volume"] = report.volume;
  d["edge_lengths"] = owned(std::vector<double>(report.edge_lengths));
  std::vector<double> angles;
  for (const auto& six : report.dihedral_angles)
    angles.insert(angles.end(), six.begin(), six.end());
  d["dihedral_angles"] = owned(std::move(angles), {report.dihedral_angles.size(), 6});
  nb::list vertices;
  for (const auto& v : report.vertices) {
    nb::dict vertex;
    vertex["kind"] = std::string(topology::to_string(v.kind));
    vertex["euler_characteristic"] = v.link_euler_characteristic;
    vertex["orientable"] = v.orientable;
    vertex["cone_points"] = v.cone_points;
    vertex["orbifold_euler_characteristic"] = v.orbifold_euler_characteristic;
    vertex["area"] = v.area;
    vertices.append(vertex);
  }
  d["vertices"] = vertices;
  d["flat_tetrahedra"] = report.flat_tetrahedra;
  if (report.certificate) d["certificate"] = structure::to_json(*report.certificate);
  if (report.strict_angles) d["angle_structure"] = structure::to_json(*report.strict_angles);
  if (report.closed_bigon) {
    const structure::ClosedBigon& bigon = *report.closed_bigon;
    nb::dict found;
    found["decides"] = bigon.decides();
    found["surface"] = std::string(structure::surface_name(bigon));
    found["consequence"] = std::string(structure::to_string(bigon.consequence));
    found["edge"] = bigon.edge;
    found["opposite"] = bigon.opposite;
    found["message"] = structure::message(bigon);
    d["closed_bigon"] = found;
  }
  return d;
}

void bind_manifold(nb::module_& module) {
  nb::class_<Manifold> type(module, "Manifold", "tripus::Manifold");
  bind_topology(type);
  bind_metric_questions(type);
  module.def("load", [](const nb::bytes& input, const Limits& limits) {
    const std::string text = as_string(input);
    return run(limits, [&](const Context& context) { return load(text, context); });
  });
  module.def("from_arrays", from_arrays);
  module.def("methods", structure::solve_method_names);
}

}  // namespace tripus::python
