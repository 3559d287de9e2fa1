#include "orthospectrum/sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tripus::orthospectrum {
namespace {

constexpr double kPi = std::numbers::pi;

/// The integral of 2 t / (e^{2t} + 1) from l to infinity: by the alternating series of
/// power = e^{-2l}, or where that is slow from 0 on, where it is pi^2 / 24, less what is before l,
/// by Simpson's rule.
double fermi_tail(double length, double power) {
  if (length < 0.5) {
    constexpr int kPieces = 32;
    const auto integrand = [](double t) { return 2 * t / (std::exp(2 * t) + 1); };
    const double step = length / kPieces;
    double sum = integrand(0) + integrand(length);
    for (int i = 1; i < kPieces; ++i) sum += (i % 2 == 1 ? 4 : 2) * integrand(i * step);
    return kPi * kPi / 24 - sum * step / 3;
  }
  double sum = 0, powers = -1;
  for (int m = 1;; ++m) {
    powers *= -power;
    const double term = powers * (length / m + 1 / (2.0 * m * m));
    sum += term;
    if (std::abs(term) < std::numeric_limits<double>::epsilon() * sum) return sum;
  }
}

/// What one end of an arc contributes.
struct Contribution {
  double area;
  std::array<double, 2> return_time;
};

Contribution contribution_of(double length) {
  const double grown = std::expm1(2 * length), power = 1 / (grown + 1);
  // The time at the distance r from the foot is t with tanh t = cosh r tanh l, so the integral of
  // t^k is 2 pi coth l times that of t^k / cosh^2 t from l on; by parts, with 1 - tanh l.
  const double factor = 2 * kPi * (grown + 2) / grown, rest = 2 / (grown + 2);
  return {4 * kPi / grown,
          {factor * (length * rest + std::log1p(power)),
           factor * (length * length * rest + 2 * fermi_tail(length, power))}};
}

}  // namespace

double boundary_area_of(double length) { return 8 * kPi / std::expm1(2 * length); }

double volume_of(double length) { return boundary_area_of(length) * (length + 1) / 4; }

double return_time_of(double length, int k) {
  return 2 * contribution_of(length).return_time[static_cast<std::size_t>(k - 1)];
}

double disc_radius(double length) { return -std::log(std::tanh(length / 2)); }

void Sums::add(double length) {
  ++count_;
  shortest_ = std::min(shortest_, length);
  const Contribution contribution = contribution_of(length);
  area_ += contribution.area;
  volume_ += contribution.area * (length + 1) / 4;
  for (std::size_t k = 0; k < 2; ++k) return_time_[k] += contribution.return_time[k];
  const auto bin = static_cast<std::size_t>(length / kBin);
  if (bin >= histogram_.size()) {
    histogram_.resize(bin + 1);
    area_histogram_.resize(bin + 1);
  }
  ++histogram_[bin];
  area_histogram_[bin] += contribution.area;
}

void Sums::add(const Sums& other) {
  count_ += other.count_;
  shortest_ = std::min(shortest_, other.shortest_);
  area_ += other.area_;
  volume_ += other.volume_;
  for (std::size_t k = 0; k < 2; ++k) return_time_[k] += other.return_time_[k];
  const std::size_t bins = std::max(histogram_.size(), other.histogram_.size());
  histogram_.resize(bins);
  area_histogram_.resize(bins);
  for (std::size_t n = 0; n < other.histogram_.size(); ++n) {
    histogram_[n] += other.histogram_[n];
    area_histogram_[n] += other.area_histogram_[n];
  }
}

}  // namespace tripus::orthospectrum
