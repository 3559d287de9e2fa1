// Proofs: of thousands of small manifolds, of covers of growing size beside the time to solve them,
// and to many digits. The baseline is a plain Krawczyk test of our own, dense and in Arb.
#include <sys/resource.h>

#include <cmath>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <benchmark/benchmark.h>

#include "geometry/edge_frames.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/digits.hpp"
#include "structure/proof/proof.hpp"
#include "structure/solve.hpp"
#include "tests/support/data_files.hpp"
#include "topology/cyclic_cover.hpp"
#include "topology/isosig.hpp"

namespace {

using namespace tripus;
using structure::detail::Arb;

struct Solved {
  topology::Triangulation triangulation;
  std::vector<double> lengths;
};

const std::vector<Solved>& solved_census() {
  static const std::vector<Solved> kCensus = [] {
    std::vector<Solved> census;
    structure::SolveOptions options;
    options.evidence = false;
    for (const auto& signature : testing::data_lines("triangulations-4.txt")) {
      topology::Triangulation triangulation(topology::decode_isosig(signature));
      auto report = structure::solve(triangulation, options);
      if (report.outcome == structure::Outcome::kGeometric)
        census.push_back({std::move(triangulation), std::move(report.edge_lengths)});
    }
    return census;
  }();
  return kCensus;
}

/// Krawczyk's test for K = 0 on x0 +- radius at 64 bits: C K(x0) + (I - C J) [-r, r] inside [-r,
/// r], C near J^-1, J the interval Hessian, with an edge held at each cusp. O(T + E^3).
bool krawczyk(const topology::Triangulation& triangulation, const std::vector<double>& x0,
              double radius) {
  const structure::detail::Precision precision(64);
  const structure::detail::ConeMetric metric(triangulation, {});
  const auto n = static_cast<Eigen::Index>(x0.size());
  std::vector<Arb> K(x0.size(), 2.0 * number_pi(Arb())), J(x0.size() * x0.size());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<Arb, 6> l, box;
    for (std::size_t e = 0; e < 6; ++e) {
      l[e] = Arb(x0[triangulation.edge_class(t, int(e))]);
      box[e] = l[e].widened(radius);
    }
    const auto at = structure::detail::precise_tetrahedron(l, false, metric.diagonal(t));
    const auto jacobian = structure::detail::precise_jacobian(box, metric.diagonal(t));
    if (!at || !jacobian) return false;
    for (int i = 0; i < 6; ++i) {
      const std::size_t a = triangulation.edge_class(t, i);
      K[a] = K[a] - at->angles[std::size_t(i)];
      for (int j = 0; j < 6; ++j) {
        Arb& entry = J[a * x0.size() + triangulation.edge_class(t, j)];
        entry = entry +
                (*jacobian)[std::size_t(geometry::packed_index(std::min(i, j), std::max(i, j)))];
      }
    }
  }
  for (const std::size_t pin : metric.pins()) {
    for (std::size_t e = 0; e < x0.size(); ++e)
      J[pin * x0.size() + e] = J[e * x0.size() + pin] = Arb(e == pin ? 1.0 : 0.0);
    K[pin] = Arb();
  }
  Eigen::MatrixXd middle(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) middle(i, j) = J[std::size_t(i * n + j)].mid();
  const Eigen::MatrixXd C = middle.inverse();
  for (Eigen::Index i = 0; i < n; ++i) {
    Arb sum;
    for (Eigen::Index k = 0; k < n; ++k) sum = sum + Arb(C(i, k)) * K[std::size_t(k)];
    for (Eigen::Index j = 0; j < n; ++j) {
      Arb entry(i == j ? 1.0 : 0.0);
      for (Eigen::Index k = 0; k < n; ++k) entry = entry - Arb(C(i, k)) * J[std::size_t(k * n + j)];
      sum = sum + entry * Arb(0.0).widened(radius);
    }
    if (!(sum.upper() < radius && sum.lower() > -radius)) return false;
  }
  return true;
}

/// The whole census of four tetrahedra; `prove_one` says whether it was proved.
template <class ProveOne>
void run_census(benchmark::State& state, ProveOne prove_one) {
  long proved = 0;
  solved_census();  // solving is not timed
  for (auto _ : state)
    for (const Solved& one : solved_census()) {
      if (!prove_one(one)) state.SkipWithError("not proved");
      ++proved;
    }
  state.SetItemsProcessed(proved);
}

void four_tetrahedra(benchmark::State& state) {
  run_census(state, [](const Solved& one) {
    return structure::prove(one.triangulation, one.lengths).proved;
  });
}
void four_tetrahedra_without_volume(benchmark::State& state) {
  structure::ProveOptions options;
  options.volume = false;
  run_census(state, [&](const Solved& one) {
    return structure::prove(one.triangulation, one.lengths, options).proved;
  });
}
void four_tetrahedra_krawczyk(benchmark::State& state) {
  run_census(state,
             [](const Solved& one) { return krawczyk(one.triangulation, one.lengths, 1e-9); });
}

topology::Triangulation cover_of_the_tripus(std::size_t tetrahedra) {
  const topology::Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  return topology::Triangulation(
      topology::cyclic_cover(tripus.gluings(), *topology::primitive_class(tripus), tetrahedra / 2));
}

/// The most memory that the process had so far, in MiB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

/// Proving a cover, and as a counter how many times as long as solving it from random lengths.
void cover(benchmark::State& state) {
  const auto tetrahedra = static_cast<std::size_t>(state.range(0));
  const topology::Triangulation triangulation = cover_of_the_tripus(tetrahedra);
  structure::SolveOptions options;
  options.method = "newton-cg";
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> sample(0.4, 0.9);
  options.initial_lengths.resize(triangulation.edge_count());
  for (double& l : options.initial_lengths) l = sample(random);
  // Processor time: the ratio is then not that of what else the machine did.
  const auto clock = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
  const double begin = clock();
  const auto report = structure::solve(triangulation, options);
  const double solving = clock() - begin;
  const double peak_of_solving = peak_memory();
  Context one;
  one.threads = 1;
  structure::Proof proof;
  double proving = 0;
  for (auto _ : state) {
    const double start = clock();
    proof = structure::prove(triangulation, report.edge_lengths, {}, one);
    proving += clock() - start;
  }
  if (!proof.proved) state.SkipWithError(proof.reason.c_str());
  state.counters["ns_per_tetrahedron"] =
      1e9 * proving / double(state.iterations()) / double(tetrahedra);
  state.counters["times_solving"] = proving / double(state.iterations()) / solving;
  state.counters["radius"] = proof.largest_radius();
  state.counters["escalated"] = double(proof.escalated);
  // Of the process: what came before counts, so that a size has to be run alone.
  state.counters["peak_MiB_solving"] = peak_of_solving;
  state.counters["peak_times_solving"] = peak_memory() / peak_of_solving;
}

/// The baseline on covers: dense.
void cover_krawczyk(benchmark::State& state) {
  const topology::Triangulation triangulation =
      cover_of_the_tripus(static_cast<std::size_t>(state.range(0)));
  const auto report = structure::solve(triangulation);
  for (auto _ : state)
    if (!krawczyk(triangulation, report.edge_lengths, 1e-9)) state.SkipWithError("not proved");
}

topology::Triangulation cover_of_the_figure_eight(std::size_t tetrahedra) {
  const topology::Triangulation m(topology::decode_isosig("cPcbbbiht"));
  return topology::Triangulation(
      topology::cyclic_cover(m.gluings(), *topology::primitive_class(m), tetrahedra / 2));
}

/// Cyclic covers of the figure-eight knot's complement: one cusp, an edge held, a factorisation.
void cusped_cover(benchmark::State& state) {
  const auto tetrahedra = static_cast<std::size_t>(state.range(0));
  const topology::Triangulation triangulation = cover_of_the_figure_eight(tetrahedra);
  const auto report = structure::solve(triangulation);
  Context one;
  one.threads = 1;
  structure::Proof proof;
  for (auto _ : state) proof = structure::prove(triangulation, report.edge_lengths, {}, one);
  if (!proof.proved) state.SkipWithError(proof.reason.c_str());
  state.counters["radius"] = proof.largest_radius();
}

/// The baseline on them.
void cusped_cover_krawczyk(benchmark::State& state) {
  const topology::Triangulation triangulation =
      cover_of_the_figure_eight(static_cast<std::size_t>(state.range(0)));
  const auto report = structure::solve(triangulation);
  for (auto _ : state)
    if (!krawczyk(triangulation, report.edge_lengths, 1e-9)) state.SkipWithError("not proved");
}

void digits_of_the_tripus(benchmark::State& state) {
  const topology::Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  const auto report = structure::solve(tripus);
  for (auto _ : state) {
    const auto proof = structure::prove(tripus, report.edge_lengths);
    const auto digits = structure::prove_digits(tripus, proof, static_cast<int>(state.range(0)));
    if (!digits.proved) state.SkipWithError(digits.reason.c_str());
    if (!digits.volume.lower.starts_with("6.451990270835032865298234421060308152813"))
      state.SkipWithError("not the volume of the tripus");
  }
}

BENCHMARK(four_tetrahedra)->Unit(benchmark::kMillisecond);
BENCHMARK(four_tetrahedra_without_volume)->Unit(benchmark::kMillisecond);
BENCHMARK(four_tetrahedra_krawczyk)
    ->Name("four_tetrahedra_krawczyk (baseline)")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(cover)->Arg(52)->Arg(516)->Arg(1000)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(
    benchmark::kMillisecond);
BENCHMARK(cover_krawczyk)
    ->Name("cover_krawczyk (baseline)")
    ->Arg(52)
    ->Arg(116)
    ->Arg(264)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(cusped_cover)->Arg(52)->Arg(264)->Arg(516)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(cusped_cover_krawczyk)
    ->Name("cusped_cover_krawczyk (baseline)")
    ->Arg(52)
    ->Arg(116)
    ->Arg(264)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);
BENCHMARK(digits_of_the_tripus)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
