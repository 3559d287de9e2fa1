// The kernel of one truncated tetrahedron: batched, scalar, against a plain implementation with the
// C library, and against its transcendental functions alone.
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <benchmark/benchmark.h>

#include "bench/kernels/transcendental_kernel.hpp"
#include "geometry/batch.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "geometry/volume.hpp"

namespace {

using namespace tripus;
using geometry::kLanes;
using geometry::kPackedJacobian;

/// More than the second-level cache: 4,096 blocks of 8 tetrahedra are 1.5 MB of lengths and 5.5 MB
/// of Jacobians.
constexpr std::size_t kBlocks = 4096;

const std::vector<double>& lengths() {
  static const std::vector<double> kLengths = [] {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> sample(0.4, 0.9);
    std::vector<double> l(kBlocks * 6 * kLanes);
    for (double& x : l) x = sample(random);
    return l;
  }();
  return kLengths;
}

std::array<double, 6> lane_of(const std::vector<double>& blocks, std::size_t t) {
  std::array<double, 6> l;
  for (std::size_t e = 0; e < 6; ++e) l[e] = blocks[(t / kLanes * 6 + e) * kLanes + t % kLanes];
  return l;
}

/// The textbook route: Gram matrix, its inverse, arc cosines, and (16) for the Jacobian.
void plain_angles(const double* l, double* theta, double* jacobian) {
  static constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  Eigen::Matrix4d g = Eigen::Matrix4d::Identity();
  for (int e = 0; e < 6; ++e)
    g(kEnds[e][0], kEnds[e][1]) = g(kEnds[e][1], kEnds[e][0]) = -std::cosh(l[e]);
  const Eigen::Matrix4d n = g.inverse();
  for (int e = 0; e < 6; ++e) {
    const int k = kEnds[5 - e][0], m = kEnds[5 - e][1];
    const double root = std::sqrt(n(k, k) * n(m, m));
    theta[e] = std::acos(-n(k, m) / root);
    const double factor = 1 / (std::sin(theta[e]) * root);
    for (int f = 0; f < 6; ++f) {
      const int a = kEnds[f][0], b = kEnds[f][1];
      const double bracket = n(k, a) * n(b, m) + n(k, b) * n(a, m) -
                             n(k, m) * (n(k, a) * n(k, b) / n(k, k) + n(m, a) * n(m, b) / n(m, m));
      jacobian[6 * e + f] = factor * std::sinh(l[f]) * bracket;
    }
  }
}

void count(benchmark::State& state, std::size_t tetrahedra) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tetrahedra));
}

void BM_Plain(benchmark::State& state) {
  double theta[6], jacobian[36];
  std::array<double, 6> reference;
  for (std::size_t t = 0; t < 100; ++t) {
    const auto l = lane_of(lengths(), t);
    plain_angles(l.data(), theta, jacobian);
    geometry::dihedral_angles(l, reference);
    for (std::size_t e = 0; e < 6; ++e)
      if (std::fabs(theta[e] - reference[e]) > 1e-12) state.SkipWithError("wrong angles");
  }
  for (auto _ : state) {
    for (std::size_t t = 0; t < kBlocks; ++t) {
      const auto l = lane_of(lengths(), t);
      plain_angles(l.data(), theta, jacobian);
      benchmark::DoNotOptimize(theta);
      benchmark::DoNotOptimize(jacobian);
    }
  }
  count(state, kBlocks);
}
BENCHMARK(BM_Plain)->Name("angles+Jacobian/plain libm and Eigen (baseline)");

void BM_Scalar(benchmark::State& state) {
  std::array<double, 6> theta;
  std::array<double, 36> jacobian;
  for (auto _ : state) {
    for (std::size_t t = 0; t < kBlocks; ++t) {
      geometry::extended_dihedral_angles(lane_of(lengths(), t), theta, jacobian);
      benchmark::DoNotOptimize(jacobian);
    }
  }
  count(state, kBlocks);
}
BENCHMARK(BM_Scalar)->Name("angles+Jacobian/scalar kernel");

void run_kernels(benchmark::State& state, const geometry::BatchKernels& kernels,
                 bool with_jacobian) {
  std::vector<double> theta(kBlocks * 6 * kLanes), jacobian(kBlocks * kPackedJacobian * kLanes);
  kernels.angles(kBlocks, lengths().data(), theta.data(), jacobian.data());
  for (std::size_t t = 0; t < 1000; ++t) {
    std::array<double, 6> reference;
    geometry::dihedral_angles(lane_of(lengths(), t), reference);
    if (lane_of(theta, t) != reference) state.SkipWithError("wrong angles");
  }
  for (auto _ : state) {
    kernels.angles(kBlocks, lengths().data(), theta.data(),
                   with_jacobian ? jacobian.data() : nullptr);
    benchmark::ClobberMemory();
  }
  count(state, kBlocks * kLanes);
}

void run_transcendentals(benchmark::State& state, bench::Transcendentals function) {
  std::vector<double> out(kBlocks * 6 * kLanes);
  for (auto _ : state) {
    function(kBlocks, lengths().data(), out.data());
    benchmark::ClobberMemory();
  }
  count(state, kBlocks * kLanes);
}

void BM_Volume(benchmark::State& state) {
  std::vector<double> theta(kBlocks * 6 * kLanes);
  geometry::batch_kernels().angles(kBlocks, lengths().data(), theta.data(), nullptr);
  for (auto _ : state) {
    for (std::size_t t = 0; t < kBlocks; ++t)
      benchmark::DoNotOptimize(geometry::volume(lane_of(theta, t)));
  }
  count(state, kBlocks);
}
BENCHMARK(BM_Volume)->Name("volume/one tetrahedron");

bench::Transcendentals transcendentals_of(std::string_view set) {
#ifdef TRIPUS_X86_KERNELS
  if (set == "avx2") return bench::avx2_transcendentals;
  if (set == "avx512") return bench::avx512_transcendentals;
#endif
  return bench::portable_transcendentals;
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& kernels : geometry::all_batch_kernels()) {
    const std::string name(kernels.name);
    benchmark::RegisterBenchmark(("angles+Jacobian/" + name).c_str(),
                                 [&](benchmark::State& s) { run_kernels(s, kernels, true); });
    benchmark::RegisterBenchmark(("angles/" + name).c_str(),
                                 [&](benchmark::State& s) { run_kernels(s, kernels, false); });
    benchmark::RegisterBenchmark(
        ("transcendentals alone/" + name).c_str(),
        [&](benchmark::State& s) { run_transcendentals(s, transcendentals_of(kernels.name)); });
  }
#ifdef TRIPUS_X86_KERNELS
  benchmark::RegisterBenchmark("transcendentals alone/libmvec, 2 lanes", [](benchmark::State& s) {
    run_transcendentals(s, bench::libmvec_transcendentals);
  });
  if (geometry::batch_kernels().name == "avx512") {
    benchmark::RegisterBenchmark("transcendentals alone/libmvec, 8 lanes", [](benchmark::State& s) {
      run_transcendentals(s, bench::libmvec_wide_transcendentals);
    });
  }
#endif
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
