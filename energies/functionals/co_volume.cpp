#include "energies/co_volume.hpp"

#include "energies/energies.hpp"

namespace tripus::energies::registered_energies {
namespace {

class InLengths final : public Functional {
 public:
  InLengths(const topology::Triangulation& triangulation,
            std::span<const topology::ConeAngle> cone_angles, const Start& start)
      : energy_(triangulation, cone_angles), start_(start.lengths.begin(), start.lengths.end()) {}

  solver::Problem& problem() override { return energy_; }
  std::vector<double> start() const override { return start_; }
  std::vector<double> lengths_at(std::span<const double> x) override {
    return {x.begin(), x.end()};
  }

 private:
  CoVolume energy_;
  std::vector<double> start_;
};

std::unique_ptr<Functional> begin(const topology::Triangulation& triangulation,
                                  std::span<const topology::ConeAngle> cone_angles,
                                  const Start& start) {
  return std::make_unique<InLengths>(triangulation, cone_angles, start);
}

}  // namespace

std::span<const Energy> co_volume() {
  static constexpr Energy kRows[] = {
      {.name = "co-volume",
       .description = "sum of the tetrahedra's co-volumes less sum k_e l_e; its gradient is -K",
       .variables = "edge lengths",
       .prefix = "",
       .begin = begin,
       .place = 0}};
  return kRows;
}

}  // namespace tripus::energies::registered_energies
