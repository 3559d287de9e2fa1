// The laws of orthospectrum/README.md on all manifolds with two and three tetrahedra.
#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "canonical/canonize.hpp"
#include "orthospectrum/boundary_surface.hpp"
#include "orthospectrum/identities.hpp"
#include "tests/support/spectra.hpp"
#include "topology/covers/covers.hpp"
#include "topology/isomorphism.hpp"
#include "topology/moves/moves.hpp"

namespace tripus::orthospectrum {
namespace {

std::vector<std::string> manifolds() {
  std::vector<std::string> names;
  for (const testing::Row& row : testing::compact_manifolds()) names.push_back(row.at("isosig"));
  for (const char* name : testing::kNonOrientable) names.emplace_back(name);
  return names;
}

// O2
TEST(OrthospectrumManifolds, PartialSumsStayBelowAndTailsAgree) {
  std::size_t with_estimates = 0;
  for (const std::string& name : manifolds()) {
    const auto manifold = testing::try_embed(name);
    ASSERT_TRUE(manifold) << name;
    const double area = testing::boundary_area(manifold->report), volume = manifold->report.volume;
    for (const double length : {1.0, 3.0, 5.0, 6.0, 6.5, 7.0}) {
      SpectrumOptions options;
      options.length = length;
      options.keep_arcs = false;
      const Spectrum spectrum =
          orthospectrum(manifold->triangulation, manifold->report.edge_lengths, options);
      EXPECT_LT(spectrum.sums.area(), area) << name;
      EXPECT_LT(spectrum.sums.volume(), volume) << name;
      EXPECT_EQ(spectrum.sums.oriented_count() % 2, 0u) << name;
      const Identities found = identities_of(spectrum.sums, length, area, volume);
      if (!found.area.tail) continue;
      ++with_estimates;
      EXPECT_NEAR(found.area.counted + found.area.tail->value, area, found.area.tail->uncertainty)
          << name << " " << length;
      EXPECT_NEAR(found.volume.counted + found.volume.tail->value, volume,
                  found.volume.tail->uncertainty)
          << name << " " << length;
      ASSERT_TRUE(found.volume_from_area) << name;
      EXPECT_NEAR(found.volume_from_area->value, volume, found.volume_from_area->uncertainty)
          << name << " " << length;
      if (length == 7.0) {
        EXPECT_LT(found.volume_from_area->uncertainty, 3e-3 * volume) << name;
      }
    }
  }
  EXPECT_GT(with_estimates, 400u);
}

// O5
TEST(OrthospectrumManifolds, EveryEdgeOfTheCanonicalDecompositionIsAnArcAndTheShortestIsOne) {
  for (const std::string& name : manifolds()) {
    const auto manifold = testing::try_embed(name);
    const auto canonical = canonical::canonize(manifold->triangulation);
    ASSERT_TRUE(canonical.manifold) << name;
    const auto edges = canonical::cell_edge_lengths(*canonical.manifold);
    ASSERT_FALSE(edges.empty()) << name;
    const auto lengths = testing::lengths_of(
        testing::spectrum_of(manifold->triangulation, manifold->report, edges.back() + 1e-6));
    ASSERT_FALSE(lengths.empty()) << name;
    EXPECT_NEAR(edges.front(), lengths.front(), 1e-9) << name;
    // Each edge is an arc, with its multiplicity.
    std::size_t next = 0;
    for (const double edge : edges) {
      while (next < lengths.size() && lengths[next] < edge - 1e-9) ++next;
      ASSERT_LT(next, lengths.size()) << name;
      EXPECT_NEAR(lengths[next++], edge, 1e-9) << name;
    }
  }
}

// O3
TEST(OrthospectrumManifolds, TwoHundredTriangulationsByMovesHaveTheSameSpectrum) {
  const std::vector<std::string> names = manifolds();
  std::size_t pairs = 0, larger = 0;
  for (std::uint64_t seed = 0; pairs < 200; ++seed) {
    ASSERT_LT(seed, 5000u);
    const std::string& name = names[seed % names.size()];
    const auto manifold = testing::try_embed(name);
    topology::Gluings gluings = manifold->triangulation.gluings();
    topology::RandomMovesOptions moves;
    moves.count = 1 + seed % 4;
    moves.seed = seed;
    moves.max_tetrahedra = gluings.tetrahedron_count() + 3;
    topology::randomize(gluings, moves);
    if (topology::is_isomorphic(gluings, manifold->triangulation.gluings())) continue;
    const topology::Triangulation other(gluings);
    structure::SolveOptions options;
    options.evidence = false;
    const structure::Report report = structure::solve(other, options);
    if (report.outcome != structure::Outcome::kGeometric) continue;
    ++pairs;
    larger += other.tetrahedron_count() > manifold->triangulation.tetrahedron_count();
    const auto lengths =
        testing::lengths_of(testing::spectrum_of(manifold->triangulation, manifold->report, 4.5));
    const auto others = testing::lengths_of(testing::spectrum_of(other, report, 4.5));
    EXPECT_LT(testing::difference(lengths, others), 1e-9) << name << " seed " << seed;
  }
  EXPECT_GT(larger, 20u);
}

// O4
TEST(OrthospectrumManifolds, EachArcHasTwoLiftsInADoubleCover) {
  std::size_t covers = 0;
  const std::vector<std::string> names = manifolds();
  for (std::size_t n = 0; n < names.size(); n += 3) {
    const auto manifold = testing::try_embed(names[n]);
    const auto below =
        testing::lengths_of(testing::spectrum_of(manifold->triangulation, manifold->report, 5));
    std::size_t here = 0;
    topology::for_each_cover(manifold->triangulation, 2, [&](const topology::Cover& cover) {
      const topology::Triangulation above(cover.gluings);
      const structure::Report report = structure::solve(above);
      EXPECT_EQ(report.outcome, structure::Outcome::kGeometric);
      const auto lifted = testing::lengths_of(testing::spectrum_of(above, report, 5));
      EXPECT_EQ(lifted.size(), 2 * below.size()) << names[n];
      for (std::size_t k = 0; k < std::min(lifted.size(), 2 * below.size()); ++k)
        EXPECT_NEAR(lifted[k], below[k / 2], 1e-9) << names[n];
      ++covers;
      return ++here < 2;
    });
  }
  EXPECT_GT(covers, 50u);
}

/// Whether a foot is on a side of its tile, which belongs to one of two tiles by a rule that labels
/// decide.
bool is_on_side(const BoundarySurface& surface, const ArcEnd& end) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 a = surface.corner(end.tile, k), b = surface.corner(end.tile, (k + 1) % 3);
    const Vector3 normal = a.cross(b);
    if (std::abs(normal.dot(Vector3(end.x, end.y, 1))) < 1e-9 * normal.norm()) return true;
  }
  return false;
}

/// Lengths of the arcs that end within each tile, corners and sides apart.
std::map<Tile, std::vector<double>> inner_ends(const topology::Triangulation& triangulation,
                                               const BoundarySurface& surface,
                                               const Spectrum& spectrum) {
  std::map<Tile, std::vector<double>> ends;
  for (std::uint32_t t = 0; t < triangulation.tetrahedron_count(); ++t)
    for (std::uint32_t v = 0; v < 4; ++v) ends[{t, v}];
  for (const Arc& arc : spectrum.arcs)
    if (arc.edge == kNoEdge)
      for (const ArcEnd& end : {arc.start, arc.end})
        if (!is_on_side(surface, end)) ends[end.tile].push_back(arc.length);
  for (auto& [tile, lengths] : ends) std::ranges::sort(lengths);
  return ends;
}

// O3
TEST(OrthospectrumManifolds, MirrorImagesAndNewLabelsChangeNothing) {
  const std::vector<std::string> names = manifolds();
  for (std::size_t n = 0; n < names.size(); n += 2) {
    const auto manifold = testing::try_embed(names[n]);
    const auto lengths =
        testing::lengths_of(testing::spectrum_of(manifold->triangulation, manifold->report, 5));
    const topology::Gluings& gluings = manifold->triangulation.gluings();
    topology::Isomorphism mirror;
    for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
      mirror.tetrahedron_images.push_back(static_cast<topology::TetrahedronIndex>(t));
      mirror.perms.push_back(topology::Perm4::from_images(1, 0, 2, 3));
    }
    for (const topology::Gluings& other :
         {topology::relabelled(gluings, mirror), topology::random_relabelling(gluings, n)}) {
      const topology::Triangulation triangulation(other);
      const structure::Report report = structure::solve(triangulation);
      const auto others = testing::lengths_of(testing::spectrum_of(triangulation, report, 5));
      EXPECT_LT(testing::difference(lengths, others), 1e-9) << names[n];
    }
  }
}

// O3
TEST(OrthospectrumManifolds, IsometriesCarryTheArcsOfOneTileToThoseOfAnother) {
  std::size_t maps = 0;
  for (const std::string& name : manifolds()) {
    const auto manifold = testing::try_embed(name);
    const topology::Gluings& gluings = manifold->triangulation.gluings();
    const auto group = topology::all_isomorphisms(gluings, gluings);
    if (group.size() < 2) continue;
    const Spectrum spectrum = testing::spectrum_of(manifold->triangulation, manifold->report, 4.5);
    const BoundarySurface surface(manifold->triangulation, manifold->report.edge_lengths);
    const auto ends = inner_ends(manifold->triangulation, surface, spectrum);
    for (const topology::Isomorphism& map : group) {
      ++maps;
      for (const auto& [tile, lengths] : ends) {
        const Tile image{
            map.tetrahedron_images[tile.tetrahedron],
            static_cast<std::uint32_t>(map.perms[tile.tetrahedron](static_cast<int>(tile.vertex)))};
        EXPECT_LT(testing::difference(lengths, ends.at(image)), 1e-9) << name;
      }
    }
  }
  EXPECT_GT(maps, 100u);
}

// O6
TEST(OrthospectrumManifolds, WordsGiveTheLengthsAndThreadsChangeNothing) {
  const std::vector<std::string> names = manifolds();
  for (std::size_t n = 0; n < names.size(); n += 5) {
    const auto manifold = testing::try_embed(names[n]);
    SpectrumOptions options;
    options.length = 5;
    options.keep_faces = true;
    Context single;
    single.threads = 1;
    const Spectrum one =
        orthospectrum(manifold->triangulation, manifold->report.edge_lengths, options, single);
    for (const Arc& arc : one.arcs) {
      const double cosh =
          cosh_along(manifold->triangulation, manifold->report.edge_lengths, arc.start.tile,
                     std::span(one.faces).subspan(arc.first_face, arc.face_count), arc.end.tile);
      ASSERT_NEAR(std::acosh(cosh), arc.length, 1e-11) << names[n];
    }
    Context context;
    context.threads = 3;
    const Spectrum three =
        orthospectrum(manifold->triangulation, manifold->report.edge_lengths, options, context);
    EXPECT_EQ(three.faces, one.faces);
    ASSERT_EQ(three.arcs.size(), one.arcs.size());
    for (std::size_t k = 0; k < one.arcs.size(); ++k) {
      ASSERT_EQ(three.arcs[k].length, one.arcs[k].length);
      ASSERT_EQ(three.arcs[k].start.tile, one.arcs[k].start.tile);
      ASSERT_EQ(three.arcs[k].start.x, one.arcs[k].start.x);
    }
    EXPECT_EQ(three.sums.area(), one.sums.area());
  }
}

// O1
TEST(OrthospectrumManifolds, DiscsOfDifferentArcsDoNotOverlap) {
  for (const char* name : {"cPcbbbihq", "dLQbcbcdhjw", "dLQbccchrqg"}) {
    const auto manifold = testing::try_embed(name);
    const Spectrum spectrum = testing::spectrum_of(manifold->triangulation, manifold->report, 5);
    std::map<Tile, std::vector<std::pair<ArcEnd, double>>> spots;
    for (const Arc& arc : spectrum.arcs)
      for (const ArcEnd& end : {arc.start, arc.end})
        spots[end.tile].emplace_back(end, disc_radius(arc.length));
    for (const auto& [tile, list] : spots) {
      for (std::size_t a = 0; a < list.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          const ArcEnd &p = list[a].first, &q = list[b].first;
          const double cosh = (1 - p.x * q.x - p.y * q.y) /
                              std::sqrt((1 - p.x * p.x - p.y * p.y) * (1 - q.x * q.x - q.y * q.y));
          EXPECT_GT(std::acosh(std::max(1.0, cosh)), list[a].second + list[b].second) << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tripus::orthospectrum
