#include "energies/co_volume.hpp"

#include "energies/energies.hpp"

namespace tripus::energies::registered_energies {
namespace {

class InLengths final : public Functional {
 public:
  InLengths(const topology::Triangulation& triangulation,
            std::span<const topology::ConeAngle> cone_angles)
      : energy_(triangulation, cone_angles) {}

  const solver::Problem& problem() const override { return energy_; }
  void to_lengths(std::vector<double>&) override {}

 private:
  CoVolume energy_;
};

std::unique_ptr<Functional> begin(const topology::Triangulation& triangulation,
                                  std::span<const topology::ConeAngle> cone_angles,
                                  const InteriorAngles&, std::vector<double>&) {
  return std::make_unique<InLengths>(triangulation, cone_angles);
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
