#include "studies/detail/theory_measurements.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "energies/co_volume.hpp"
#include "studies/detail/method_run.hpp"
#include "studies/detail/statistics.hpp"
#include "studies/study.hpp"

namespace tripus::studies::detail {

Spectrum spectrum(const topology::Triangulation& triangulation, std::span<const double> lengths) {
  const energies::CoVolume energy(triangulation);
  return solver::extreme_eigenvalues(energy.at(lengths, solver::Order::kSecond));
}

namespace {

using Vector = std::vector<double>;

/// A random direction of Euclidean length 1.
Vector random_direction(std::size_t n, Random& random) {
  Vector direction(n);
  double squares = 0;
  for (double& value : direction) {
    value = random.uniform(-1, 1);
    squares += value * value;
  }
  for (double& value : direction) value /= std::sqrt(squares);
  return direction;
}

double distance(std::span<const double> a, std::span<const double> b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(squares);
}

Vector shifted(std::span<const double> x, const Vector& direction, double by) {
  Vector result(x.begin(), x.end());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += by * direction[i];
  return result;
}

/// Follows dx/dt = K by the classical Runge-Kutta method.
class Flow {
 public:
  explicit Flow(const topology::Triangulation& triangulation)
      : energy_(triangulation), n_(triangulation.edge_count()) {}

  /// K [E] at x.
  Vector curvature(const Vector& x) {
    const auto at = energy_.at(x);
    Vector K(at.gradient().begin(), at.gradient().end());
    for (double& k : K) k = -k;
    return K;
  }

  void step(Vector& x, double dt) {
    const Vector a = curvature(x);
    const Vector b = curvature(shifted(x, a, dt / 2));
    const Vector c = curvature(shifted(x, b, dt / 2));
    const Vector d = curvature(shifted(x, c, dt));
    for (std::size_t i = 0; i < n_; ++i) x[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  }

 private:
  energies::CoVolume energy_;
  std::size_t n_;
};

double shortest(std::span<const double> x) { return *std::min_element(x.begin(), x.end()); }

double norm(const Vector& v) {
  return std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.0));
}

}  // namespace

double newton_order(const topology::Triangulation& triangulation, std::span<const double> metric,
                    std::uint64_t seed, const Stop& stop) {
  Random random(seed);
  const Vector direction = random_direction(metric.size(), random);
  Vector before, after;
  for (int k = 0; k <= 8; ++k) {
    const double size = shortest(metric) * std::pow(10.0, -2.5 - 0.25 * k);
    const Vector start = shifted(metric, direction, size);
    const MethodRun run = run_method(triangulation, "newton", start,
                                     {.tolerance = 1e-15, .max_iterations = 1, .stop = stop});
    const double error = distance(run.report.edge_lengths, metric);
    if (!(error > 1e-13 * norm(start)) || error >= size) continue;
    before.push_back(std::log(size));
    after.push_back(std::log(error));
  }
  return slope(before, after);
}

double euler_limit(const topology::Triangulation& triangulation, std::span<const double> metric,
                   double largest, std::uint64_t seed, const Stop& stop) {
  constexpr int kSteps = 1000;
  Random random(seed);
  const Vector start =
      shifted(metric, random_direction(metric.size(), random), 1e-7 * shortest(metric));
  const double size = distance(start, metric);
  Flow flow(triangulation);
  const auto stable = [&](double step) {
    Vector x = start;
    for (int k = 0; k < kSteps && !stop; ++k) {
      const Vector K = flow.curvature(x);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * K[i];
      if (!(distance(x, metric) < 1e3 * size)) return false;
    }
    return distance(x, metric) < size;
  };
  double lower = 0.5 / largest, upper = 8 / largest;
  while (upper - lower > 1e-4 * lower && !stop) {
    const double middle = (lower + upper) / 2;
    (stable(middle) ? lower : upper) = middle;
  }
  return (lower + upper) / 2;
}

Decay flow_decay(const topology::Triangulation& triangulation, std::span<const double> metric,
                 const Spectrum& spectrum, std::uint64_t seed, const Stop& stop) {
  Random random(seed);
  const double size = 0.05 * shortest(metric);
  Vector x = shifted(metric, random_direction(metric.size(), random), 0.1 * size);
  x = shifted(x, spectrum.slowest, size);
  Flow flow(triangulation);
  const double dt = 0.2 / spectrum.largest;
  // Long enough for the slowest mode to be all that is left: it decays by e^-1 in 1/lambda_min.
  const auto window = std::size_t(std::ceil(1 / (spectrum.smallest * dt)));
  Decay result;
  Vector norms{norm(flow.curvature(x))};
  while (norms.back() > 1e-9 && norms.size() < 200000 && !stop) {
    flow.step(x, dt);
    norms.push_back(norm(flow.curvature(x)));
    result.monotone = result.monotone && norms.back() < norms[norms.size() - 2];
  }
  result.steps = double(norms.size() - 1);
  const std::size_t back = std::min(window, norms.size() - 1);
  result.rate = std::log(norms[norms.size() - 1 - back] / norms.back()) / (dt * double(back));
  return result;
}

}  // namespace tripus::studies::detail
