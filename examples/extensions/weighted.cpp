// An energy of one's own, in its own variables: the co-volume in lengths times the root of the
// edge's valence. It can be solved by every minimiser, as --method weighted:NAME. This file is all
// that it takes.
#include <cmath>
#include <vector>

#include "energies/co_volume.hpp"
#include "energies/energies.hpp"
#include "solver/dense_problem.hpp"

namespace tripus::energies::registered_energies {
namespace {

class Weighted final : public Functional, private solver::DenseProblem {
 public:
  Weighted(const topology::Triangulation& triangulation,
           std::span<const topology::ConeAngle> cone_angles)
      : DenseProblem(triangulation.edge_count()), energy_(triangulation, cone_angles) {
    for (std::size_t e = 0; e < dimension(); ++e)
      weight_.push_back(1 / std::sqrt(static_cast<double>(triangulation.corners(e).size())));
  }

  const solver::Problem& problem() const override { return *this; }
  void to_lengths(std::vector<double>& y) override { y = lengths_of(y); }
  void from_lengths(std::vector<double>& x) const {
    for (std::size_t e = 0; e < x.size(); ++e) x[e] /= weight_[e];
  }

 private:
  std::optional<double> value(std::span<const double> y,
                              std::span<double> gradient) const override {
    const CoVolumeAt at = energy_.at(lengths_of(y));
    if (!at.is_defined()) return std::nullopt;
    for (std::size_t e = 0; e < gradient.size(); ++e) gradient[e] = weight_[e] * at.gradient()[e];
    return at.value();
  }
  void hessian(std::span<const double> y, std::span<double> H) const override {
    const CoVolumeAt at = energy_.at(lengths_of(y), solver::Order::kSecond);
    const std::size_t n = dimension();
    std::vector<double> direction(n), product(n);
    for (std::size_t j = 0; j < n; ++j) {
      direction[j] = weight_[j];
      at.hessian_times(direction, product);
      direction[j] = 0;
      for (std::size_t i = 0; i < n; ++i) H[n * i + j] = weight_[i] * product[i];
    }
  }

  std::vector<double> lengths_of(std::span<const double> y) const {
    std::vector<double> lengths(y.begin(), y.end());
    for (std::size_t e = 0; e < lengths.size(); ++e) lengths[e] *= weight_[e];
    return lengths;
  }

  CoVolume energy_;
  std::vector<double> weight_;  // a length is this times its variable
};

std::unique_ptr<Functional> begin(const topology::Triangulation& triangulation,
                                  std::span<const topology::ConeAngle> cone_angles,
                                  const InteriorAngles&, std::vector<double>& x) {
  auto functional = std::make_unique<Weighted>(triangulation, cone_angles);
  functional->from_lengths(x);
  return functional;
}

}  // namespace

std::span<const Energy> weighted() {
  static constexpr Energy kRows[] = {
      {.name = "weighted",
       .description = "the co-volume in lengths times the root of the valence",
       .variables = "edge lengths times the root of the valence",
       .prefix = "weighted:",
       .tolerance = 0.1,
       .begin = begin}};
  return kRows;
}

}  // namespace tripus::energies::registered_energies
