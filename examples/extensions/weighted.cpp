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
           std::span<const topology::ConeAngle> cone_angles, std::span<const double> lengths)
      : DenseProblem(lengths.size()),
        energy_(triangulation, cone_angles),
        start_(lengths.size()),
        weight_(lengths.size()) {
    for (std::size_t e = 0; e < lengths.size(); ++e) {
      weight_[e] = 1 / std::sqrt(static_cast<double>(triangulation.corners(e).size()));
      start_[e] = lengths[e] / weight_[e];
    }
  }

  solver::Problem& problem() override { return *this; }
  std::vector<double> start() const override { return start_; }
  std::vector<double> lengths_at(std::span<const double> y) override {
    std::vector<double> lengths(y.begin(), y.end());
    for (std::size_t e = 0; e < lengths.size(); ++e) lengths[e] *= weight_[e];
    return lengths;
  }

 private:
  std::optional<double> value(std::span<const double> y, std::span<double> gradient) override {
    double f = 0;
    const Request both{.value = &f, .second_derivatives = true};
    if (!energy_.evaluate(lengths_at(y), gradient, both)) return std::nullopt;
    for (std::size_t e = 0; e < gradient.size(); ++e) gradient[e] *= weight_[e];
    return f;
  }
  void hessian(std::span<const double>, std::span<double> H) override {
    const std::size_t n = dimension();
    std::vector<double> direction(n), product(n);
    for (std::size_t j = 0; j < n; ++j) {
      direction[j] = weight_[j];
      energy_.hessian_times(direction, product);
      direction[j] = 0;
      for (std::size_t i = 0; i < n; ++i) H[n * i + j] = weight_[i] * product[i];
    }
  }

  CoVolume energy_;
  std::vector<double> start_, weight_;
};

std::unique_ptr<Functional> begin(const topology::Triangulation& triangulation,
                                  std::span<const topology::ConeAngle> cone_angles,
                                  const Start& start) {
  return std::make_unique<Weighted>(triangulation, cone_angles, start.lengths);
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
