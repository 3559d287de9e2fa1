#include "orthospectrum/sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tripus::orthospectrum {
namespace {

constexpr double kPi = std::numbers::pi;

/// The integral of t^n 2 / (e^{2t} + 1) from l to infinity, n = 0 or 1: by the alternating series
/// of e^{-2mt}, or where that is slow from 0 on, where it is log 2 and pi^2 / 24, less what is
/// before l, by Simpson's rule.
double fermi_tail(double length, int n) {
  if (n == 0) return std::log1p(std::exp(-2 * length));
  const auto integrand = [](double t) { return 2 * t / (std::exp(2 * t) + 1); };
  if (length < 0.5) {
    constexpr int kPieces = 32;
    const double step = length / kPieces;
    double sum = integrand(0) + integrand(length);
    for (int i = 1; i < kPieces; ++i) sum += (i % 2 == 1 ? 4 : 2) * integrand(i * step);
    return kPi * kPi / 24 - sum * step / 3;
  }
  double sum = 0, power = 1;
  const double ratio = -std::exp(-2 * length);
  for (int m = 1;; ++m) {
    power *= ratio;
    const double term = -power * (length / m + 1 / (2.0 * m * m));
    sum += term;
    if (std::abs(term) < std::numeric_limits<double>::epsilon() * sum) return sum;
  }
}

}  // namespace

double boundary_area_of(double length) { return 8 * kPi / std::expm1(2 * length); }

double volume_of(double length) { return 2 * kPi * (length + 1) / std::expm1(2 * length); }

double return_time_of(double length, int k) {
  // The time at the distance r from the foot is t with tanh t = cosh r tanh l, so the integral is
  // 2 pi coth l times that of t^k / cosh^2 t from l on; by parts.
  const double rest = 2 / (std::exp(2 * length) + 1);  // 1 - tanh l
  const double by_parts = std::pow(length, k) * rest + k * fermi_tail(length, k - 1);
  return 2 * (2 * kPi / std::tanh(length)) * by_parts;
}

double disc_radius(double length) { return -std::log(std::tanh(length / 2)); }

void Sums::add(double length) {
  ++count_;
  const double area = boundary_area_of(length) / 2;
  area_ += area;
  volume_ += area * (length + 1) / 4;
  for (int k : {1, 2})
    return_time_[static_cast<std::size_t>(k - 1)] += return_time_of(length, k) / 2;
  const auto bin = static_cast<std::size_t>(length / kBin);
  if (bin >= histogram_.size()) {
    histogram_.resize(bin + 1);
    area_histogram_.resize(bin + 1);
  }
  ++histogram_[bin];
  area_histogram_[bin] += area;
}

void Sums::add(const Sums& other) {
  count_ += other.count_;
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
