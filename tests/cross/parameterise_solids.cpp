// Harmonic maps of solids onto their hyperbolic manifolds.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "meshing/tube/tube_surface.hpp"
#include "meshing/validate_tetrahedra.hpp"
#include "parameterise/harmonic_map.hpp"
#include "parameterise/quality.hpp"
#include "parameterise/refine.hpp"
#include "tests/support/data_files.hpp"

namespace tripus::parameterise {
namespace {

constexpr double kTripusVolume = 6.451990270835;  // data/manifolds-2-3.tsv, 12 digits

/// A surface, or the drawing of a graph.
meshing::MeshFile read_example(const std::string& name) {
  if (name.ends_with(".json"))
    return meshing::SurfaceFile{meshing::tube_surface(meshing::read_spatial_graph(
                                    testing::data_text("../examples/graphs/" + name))),
                                {}};
  const std::string path = "../examples/surfaces/" + name;
  return meshing::read_mesh(testing::data_text(path), name,
                            [](const std::string&) { return std::string(); });
}

struct Example {
  const char* file;
  double volume;
};

/// Images in the frames of the first tetrahedra change with the frames; distances along edges not.
std::vector<double> edge_lengths(MarkedSolid& solid, const std::vector<Vector4>& points) {
  std::vector<double> lengths;
  for (const energies::HarmonicEdge& e : weighted_edges(solid, Weights::kUniform).edges)
    lengths.push_back(
        geometry::hyperbolic_distance(points[e.a], solid.group->matrix(e.isometry) * points[e.b]));
  return lengths;
}

/// Of the Hessian at the base points: as many as it has negative eigenvalues (Sylvester).
int negative_pivots(const energies::HarmonicEnergy& energy) {
  const auto at = energy.at(std::vector<double>(energy.dimension(), 0.0), solver::Order::kSecond);
  const solver::SparsityPattern& pattern = energy.hessian_pattern();
  std::vector<double> entries(pattern.row.size());
  at->hessian_values(entries);
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t column = 0; column < energy.dimension(); ++column)
    for (auto k = static_cast<std::size_t>(pattern.column_start[column]);
         k < static_cast<std::size_t>(pattern.column_start[column + 1]); ++k)
      triplets.emplace_back(pattern.row[k], static_cast<int>(column), entries[k]);
  const auto n = static_cast<Eigen::Index>(energy.dimension());
  Eigen::SparseMatrix<double> lower(n, n);
  lower.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(lower);
  EXPECT_EQ(factors.info(), Eigen::Success);
  return static_cast<int>((factors.vectorD().array() <= 0).count());
}

class Solids : public ::testing::TestWithParam<Example> {};

/// What every harmonic map of a marked solid has to be; its quality.
Quality expect_harmonic(MarkedSolid& solid, const HarmonicMap& map) {
  EXPECT_EQ(map.termination, solver::Termination::kConverged);
  EXPECT_LT(map.max_gradient, 1e-10);
  EXPECT_LT(relator_defect(solid), 1e-12);
  EXPECT_LT(equivariance_defect(solid), 1e-10);
  const Quality found = quality(solid, map.points);
  EXPECT_LT(found.off_boundary, 1e-12);
  // Once covered, whatever is turned over: the map has degree 1.
  EXPECT_NEAR(found.image_volume, solid.report.volume, 1e-8);
  return found;
}

TEST_P(Solids, HaveAMarkingAndAHarmonicMap) {
  const auto solid = mark_solid(read_example(GetParam().file));
  EXPECT_NEAR(solid->report.volume, GetParam().volume, 1e-11);
  EXPECT_EQ(solid->planes, 1u);
  EXPECT_LE(solid->record_bytes, 10 * solid->steps + 64);
  const HarmonicMap map = harmonic_map(*solid, Weights::kFiniteElements);
  const Quality found = expect_harmonic(*solid, map);
  EXPECT_LT(found.inverted, solid->mesh.tetrahedra.size() / 3);

  // A minimum: some weights are negative, and the Hessian is positive all the same.
  energies::HarmonicEnergy energy =
      energy_of(*solid, weighted_edges(*solid, Weights::kFiniteElements), map.points);
  EXPECT_EQ(negative_pivots(energy), 0);

  // Another simplification: other frames, another domain, another start.
  const auto marked_anew = mark_solid(read_example(GetParam().file), {.seed = 3});
  EXPECT_NEAR(harmonic_map(*marked_anew, Weights::kFiniteElements).energy, map.energy,
              1e-11 * map.energy);

  // The same minimum from elsewhere: points moved by 1, and another fundamental domain.
  const std::vector<double> lengths = edge_lengths(*solid, map.points);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int start = 0; start < 2; ++start) {
    std::vector<Vector4> points = solid->start;
    const Matrix4 far = solid->group->matrix(solid->group->of_letter(1));
    for (Vector4& point : points) {
      geometry::Vector3 step(normal(random), normal(random), normal(random));
      step *= std::sinh(1.0) / step.norm();
      point = start == 0 ? geometry::on_hyperboloid(point + Vector4(step[0], step[1], step[2], 0))
                         : Vector4(far * point);
    }
    const HarmonicMap other = harmonic_map(*solid, Weights::kFiniteElements, {}, {}, points);
    EXPECT_EQ(other.termination, solver::Termination::kConverged);
    EXPECT_NEAR(other.energy, map.energy, 1e-9 * map.energy);
    const std::vector<double> same = edge_lengths(*solid, other.points);
    for (std::size_t e = 0; e < lengths.size(); ++e) EXPECT_NEAR(same[e], lengths[e], 1e-7);
    // Signs are of the map and not of the rounding: the same in other frames.
    const Quality again = quality(*solid, other.points);
    EXPECT_EQ(again.inverted, found.inverted);
    EXPECT_EQ(again.flat, found.flat);
    for (std::size_t t = 0; t < found.cells.size(); ++t)
      EXPECT_EQ(again.cells[t].orientation, found.cells[t].orientation) << t;
  }
}

// Another problem (residuals, then balance of forces), another method.
TEST_P(Solids, HaveTheSameMapByCeres) {
  const auto solid = mark_solid(read_example(GetParam().file));
  const HarmonicMap map = harmonic_map(*solid, Weights::kUniform);
  const std::vector<double> lengths = edge_lengths(*solid, map.points);
  MapOptions by_ceres;
  by_ceres.minimiser = Minimiser::kCeres;
  by_ceres.max_iterations = 1000;
  by_ceres.tolerance = 1e-10;
  const HarmonicMap other = harmonic_map(*solid, Weights::kUniform, by_ceres);
  EXPECT_EQ(other.termination, solver::Termination::kConverged);
  EXPECT_LT(other.max_gradient, 1e-10);
  EXPECT_NEAR(other.energy, map.energy, 1e-11 * map.energy);
  const std::vector<double> same = edge_lengths(*solid, other.points);
  for (std::size_t e = 0; e < lengths.size(); ++e) EXPECT_NEAR(same[e], lengths[e], 1e-8);
}

// The simplification of four-legs twists it: frames are chosen anew on the way back. Of the
// drawings, these are all that have a metric and no torus in their boundary.
INSTANTIATE_TEST_SUITE_P(Examples, Solids,
                         ::testing::Values(Example{"knotted-y.off", kTripusVolume},
                                           Example{"knotted-theta.off", kTripusVolume},
                                           Example{"knotted-y.json", kTripusVolume},
                                           Example{"knotted-theta.json", kTripusVolume},
                                           Example{"four-legs.json", 11.448776109640}),
                         [](const auto& parameter) {
                           std::string name = parameter.param.file;
                           name.replace(name.find('.'), 1, "_");
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// Meshes of one solid with other tetrahedra. The relators hold however many there are.
class Meshes : public ::testing::TestWithParam<const char*> {};

TEST_P(Meshes, HaveTheEnergyOfTheSolid) {
  std::vector<double> energies;
  for (const std::size_t tetrahedra : {20'000u, 60'000u, 200'000u}) {
    MarkOptions options;
    options.tetrahedralize.tetrahedra = tetrahedra;
    const auto solid = mark_solid(read_example(GetParam()), options);
    const HarmonicMap map = harmonic_map(*solid, Weights::kFiniteElements);
    expect_harmonic(*solid, map);
    energies.push_back(map.energy);
  }
  EXPECT_LT(energies[1], energies[0]);
  EXPECT_LT(energies[2], energies[1]);
  EXPECT_LT(energies[1] / energies[2] - 1, 0.05);
  EXPECT_LT(energies[1] - energies[2], 0.7 * (energies[0] - energies[1]));
}

INSTANTIATE_TEST_SUITE_P(Examples, Meshes, ::testing::Values("knotted-y.off", "knotted-theta.off"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           name.replace(name.find('.'), 1, "_");
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

double volume_of(const meshing::TetrahedralMesh& mesh) {
  double sum = 0;
  for (const meshing::Tetrahedron& t : mesh.tetrahedra) {
    std::array<geometry::Vector3, 4> corner;
    for (std::size_t v = 0; v < 4; ++v)
      corner[v] = Eigen::Map<const geometry::Vector3>(mesh.points[t[v]].data());
    sum += (corner[1] - corner[0]).cross(corner[2] - corner[0]).dot(corner[3] - corner[0]) / 6;
  }
  return sum;
}

/// The same surface, each triangle cut into four.
meshing::MeshFile quartered(meshing::MeshFile file) {
  meshing::SurfaceMesh& surface = std::get<meshing::SurfaceFile>(file).mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> halfway;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] =
        halfway.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(surface.points.size()));
    if (is_new) {
      meshing::Point point;
      for (std::size_t k = 0; k < 3; ++k)
        point[k] = (surface.points[a][k] + surface.points[b][k]) / 2;
      surface.points.push_back(point);
    }
    return place->second;
  };
  std::vector<meshing::Triangle> parts;
  for (const auto& [a, b, c] : surface.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  surface.triangles = std::move(parts);
  return file;
}

class RefinedSolids : public ::testing::TestWithParam<const char*> {};

TEST_P(RefinedSolids, KeepSetMarkingAndPlanes) {
  const auto solid = mark_solid(read_example(GetParam()));
  const meshing::TetrahedralMesh coarse = solid->mesh;
  const double energy = harmonic_map(*solid, Weights::kFiniteElements).energy;
  const HarmonicMap map = refined_map(*solid, Weights::kFiniteElements, 6000);
  expect_harmonic(*solid, map);
  // Linear maps of the old mesh are linear on the new one.
  EXPECT_LT(map.energy, energy);
  const auto& [points, tetrahedra] = solid->mesh;
  EXPECT_GE(tetrahedra.size(), 6000u);
  EXPECT_LT(tetrahedra.size(), 6100u);
  EXPECT_TRUE(std::equal(coarse.points.begin(), coarse.points.end(), points.begin()));
  EXPECT_NEAR(volume_of(solid->mesh), volume_of(coarse), 1e-12 * volume_of(coarse));
  const meshing::Solid checked = meshing::require_valid(solid->mesh);
  EXPECT_EQ(checked.boundary_genera, solid->boundary_genera);
  // It is the map of this mesh, however it was reached.
  const auto marked_anew = mark_solid(meshing::TetrahedralFile{solid->mesh, {}});
  EXPECT_NEAR(harmonic_map(*marked_anew, Weights::kFiniteElements).energy, map.energy,
              1e-10 * map.energy);
}

TEST_P(RefinedSolids, AreBisectedWhereTheMapStretches) {
  const auto solid = mark_solid(read_example(GetParam()));
  HarmonicMap map = harmonic_map(*solid, Weights::kCotangent);
  const std::vector<double> before = edge_lengths(*solid, map.points);
  refine(*solid, map.points, 4 * solid->mesh.tetrahedra.size());
  const std::vector<double> after = edge_lengths(*solid, map.points);
  EXPECT_LT(std::ranges::max(after), 0.75 * std::ranges::max(before));
  // The map as it was, seen on another mesh: halfway points change no linear map, up to curvature.
  EXPECT_NEAR(quality(*solid, map.points).image_volume, solid->report.volume, 1e-8);
  EXPECT_LT(equivariance_defect(*solid), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Examples, RefinedSolids,
                         ::testing::Values("knotted-y.json", "knotted-theta.json",
                                           "four-legs.json"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           name.replace(name.find('.'), 1, "_");
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// Its tubes have three sides: meshes that are refined inside alone come to no common energy.
TEST(FourLegs, ComeToOneEnergyFromTwoSurfaces) {
  std::array<std::vector<double>, 2> energies;
  for (std::size_t surface = 0; surface < 2; ++surface)
    for (const std::size_t tetrahedra : {20'000u, 40'000u, 80'000u}) {
      meshing::MeshFile file = read_example("four-legs.json");
      const auto solid = mark_solid(surface == 0 ? std::move(file) : quartered(std::move(file)));
      const HarmonicMap map = refined_map(*solid, Weights::kFiniteElements, tetrahedra);
      expect_harmonic(*solid, map);
      energies[surface].push_back(map.energy);
    }
  for (const std::vector<double>& e : energies) {
    EXPECT_LT(e[1], e[0]);
    EXPECT_LT(e[2], e[1]);
    EXPECT_LT(e[1] - e[2], 0.75 * (e[0] - e[1]));
  }
  EXPECT_NEAR(energies[1][2] / energies[0][2], 1, 0.05);
  EXPECT_LT(std::abs(energies[1][2] - energies[0][2]), std::abs(energies[1][0] - energies[0][0]));
}

TEST(SignedVolume, IsThatOfTheFlatOneIfSmallAndChangesSign) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 50; ++n) {
    std::array<Vector4, 4> corners;
    for (Vector4& corner : corners)
      corner = geometry::on_hyperboloid(1e-3 *
                                        Vector4(normal(random), normal(random), normal(random), 0));
    geometry::Vector3 edges[3];
    for (int k = 0; k < 3; ++k)
      edges[k] = (corners[static_cast<std::size_t>(k + 1)] - corners[0]).head<3>();
    const double flat = edges[0].cross(edges[1]).dot(edges[2]) / 6;
    const double volume = signed_volume(corners);
    EXPECT_NEAR(volume, flat, 1e-4 * std::abs(flat) + 1e-20);
    std::swap(corners[0], corners[1]);
    EXPECT_NEAR(signed_volume(corners), -volume, 1e-12 * std::abs(volume));
  }
}

// Cut in two by a point on an edge; also where it is large and is subdivided.
TEST(SignedVolume, IsAdditive) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 30; ++n) {
    std::array<Vector4, 4> corners;
    for (Vector4& corner : corners)
      corner = geometry::on_hyperboloid((n % 2 == 0 ? 0.3 : 3.0) *
                                        Vector4(normal(random), normal(random), normal(random), 0));
    const Vector4 sum = 0.3 * corners[0] + 0.7 * corners[1];
    const Vector4 cut =
        geometry::on_hyperboloid(sum / std::sqrt(-geometry::lorentz_product(sum, sum)));
    auto one = corners, two = corners;
    one[0] = cut;
    two[1] = cut;
    const double whole = signed_volume(corners);
    EXPECT_NEAR(signed_volume(one) + signed_volume(two), whole, 1e-9 * (1e-3 + std::abs(whole)));
  }
}

}  // namespace
}  // namespace tripus::parameterise
