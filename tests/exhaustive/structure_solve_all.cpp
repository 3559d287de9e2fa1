// Eight at a time or one by one: the same answers, on all triangulations up to four tetrahedra.
#include <algorithm>
#include <atomic>
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "structure/detail/lane_newton.hpp"
#include "structure/solve.hpp"
#include "structure/solve_all.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"

namespace tripus::structure {
namespace {

using topology::Triangulation;

std::vector<Triangulation> list(const std::string& file) {
  std::vector<Triangulation> all;
  for (const std::string& line : testing::data_lines(file))
    all.emplace_back(topology::decode_isosig(line));
  return all;
}

/// The numbers of the k-th answer are those of the report.
void expect_same(const Solutions& solutions, std::size_t k, const Report& report) {
  ASSERT_EQ(solutions.outcomes[k], report.outcome);
  if (report.outcome != Outcome::kGeometric) {
    ASSERT_TRUE(solutions.reports.contains(k));
    const Report& own = solutions.reports.at(k);
    EXPECT_EQ(own.certificate.has_value(), report.certificate.has_value());
    EXPECT_EQ(own.flat_tetrahedra, report.flat_tetrahedra);
    EXPECT_EQ(own.message, report.message);
    return;
  }
  EXPECT_LE(solutions.max_curvature[k], 1e-14);
  EXPECT_NEAR(solutions.volumes[k], report.volume, 2e-14);
  ASSERT_EQ(solutions.lengths(k).size(), report.edge_lengths.size());
  for (std::size_t e = 0; e < report.edge_lengths.size(); ++e)
    EXPECT_NEAR(solutions.lengths(k)[e], report.edge_lengths[e], 1e-12);
  ASSERT_EQ(solutions.angles(k).size(), report.dihedral_angles.size());
  for (std::size_t t = 0; t < report.dihedral_angles.size(); ++t)
    for (std::size_t e = 0; e < 6; ++e)
      EXPECT_NEAR(solutions.angles(k)[t][e], report.dihedral_angles[t][e], 1e-12);
}

class SolveAll : public ::testing::TestWithParam<const char*> {};

TEST_P(SolveAll, AnswersAsSolve) {
  const auto triangulations = list(GetParam());
  const Solutions solutions = solve_all(triangulations);
  ASSERT_EQ(solutions.size(), triangulations.size());
  std::size_t geometric = 0, one_by_one = 0;
  for (std::size_t k = 0; k < triangulations.size(); ++k) {
    SCOPED_TRACE(topology::isosig(triangulations[k].gluings()));
    const Report report = solve(triangulations[k]);
    expect_same(solutions, k, report);
    if (HasFatalFailure()) return;
    geometric += report.outcome == Outcome::kGeometric;
    one_by_one += report.outcome == Outcome::kGeometric && solutions.reports.contains(k);
  }
  EXPECT_GT(geometric, 0u);
  EXPECT_LE(one_by_one, geometric / 100);  // nearly all metrics are found eight at a time
  RecordProperty("one_by_one", static_cast<int>(one_by_one));
}

INSTANTIATE_TEST_SUITE_P(Lists, SolveAll,
                         ::testing::Values("triangulations-2.txt", "triangulations-3.txt",
                                           "triangulations-4.txt"));

TEST(SolveAll, AnswersDoNotDependOnTheOthers) {
  const auto all = list("triangulations-4.txt");
  const Solutions together = solve_all(all);
  for (const std::size_t step : {1u, 7u, 800u})
    for (std::size_t k = 0; k < all.size(); k += step == 1 ? 97 : step) {
      const std::size_t last = std::min(all.size(), k + (step == 1 ? 1 : 13));
      const Solutions some = solve_all(std::span(all).subspan(k, last - k));
      for (std::size_t i = 0; i < some.size(); ++i) {
        EXPECT_EQ(some.volumes[i], together.volumes[k + i]);  // to the bit
        EXPECT_TRUE(std::ranges::equal(some.lengths(i), together.lengths(k + i)));
        EXPECT_EQ(some.iterations[i], together.iterations[k + i]);
      }
    }
}

/// Everything that lanes find in the list, by number, as numbers to be compared to the bit.
std::vector<std::vector<double>> found_by(const geometry::BatchKernels& kernels,
                                          const std::vector<Triangulation>& all) {
  std::vector<std::vector<double>> found(all.size());
  std::map<std::size_t, std::unique_ptr<detail::LaneNewton>> shapes;  // by edge classes
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!detail::LaneNewton::takes(all[k])) continue;
    auto& newton = shapes[all[k].edge_count()];
    if (!newton) {
      const auto keep = [&, edges = all[k].edge_count()](const detail::LaneResult& result) {
        auto& numbers = found[result.number];
        if (!result.found) return;
        numbers = {result.volume, result.max_curvature, static_cast<double>(result.iterations)};
        for (std::size_t e = 0; e < edges; ++e)
          numbers.push_back(result.length[detail::LaneNewton::kLanes * e]);
        for (std::size_t q = 0; q < 6 * all[result.number].tetrahedron_count(); ++q)
          numbers.push_back(result.angle[detail::LaneNewton::kLanes * q]);
      };
      newton = std::make_unique<detail::LaneNewton>(all[k], keep, kernels);
    }
    newton->add(all[k], k);
  }
  for (auto& [edges, newton] : shapes) newton->finish();
  return found;
}

TEST(SolveAll, EveryInstructionSetGivesTheSameBits) {
  const auto all = list("triangulations-4.txt");
  ASSERT_EQ(all.size(), 11048u);
  const auto sets = geometry::all_batch_kernels();
  const auto portable = found_by(sets[0], all);
  EXPECT_GT(std::ranges::count_if(portable, [](const auto& each) { return !each.empty(); }), 5800);
  for (const geometry::BatchKernels& kernels : sets.subspan(1))
    EXPECT_TRUE(found_by(kernels, all) == portable) << kernels.name;
}

TEST(SolveAll, TakesWhateverSolveTakes) {
  EXPECT_EQ(solve_all({}).size(), 0u);
  // Small, with a cusp, closed up to cusps, and twenty tetrahedra.
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  std::vector<Triangulation> mixed;
  mixed.push_back(tripus);
  mixed.emplace_back(topology::decode_isosig("cPcbbbiht"));  // the figure-eight knot
  mixed.emplace_back(
      topology::cyclic_cover(tripus.gluings(), *topology::primitive_class(tripus), 10));
  mixed.push_back(tripus);
  const Solutions solutions = solve_all(mixed);
  for (std::size_t k = 0; k < mixed.size(); ++k) expect_same(solutions, k, solve(mixed[k]));
  EXPECT_NEAR(solutions.volumes[1], 2.0298832128193074, 1e-13);

  // Two components.
  std::vector<Triangulation> refused{tripus};
  topology::Gluings two = tripus.gluings();
  two.resize(4);
  for (std::size_t t = 0; t < 2; ++t)
    for (int f = 0; f < 4; ++f)
      two.set_one_side(2 + t, f, 2 + two.neighbour(t, f), two.gluing(t, f));
  refused.emplace_back(two);
  EXPECT_THROW(solve_all(refused), InvalidInput);

  const std::atomic<bool> stop = true;
  const Solutions stopped = solve_all(mixed, &stop);
  EXPECT_EQ(stopped.outcomes, std::vector(4, Outcome::kUnresolved));
}

}  // namespace
}  // namespace tripus::structure
