#include "energies/energies.hpp"
#include "energies/volume_in_angles.hpp"

namespace tripus::energies::registered_energies {
namespace {

class InAngles final : public Functional {
 public:
  InAngles(const topology::Triangulation& triangulation, std::span<const double> interior)
      : energy_(triangulation, interior) {}

  const solver::Problem& problem() const override { return energy_; }
  void to_lengths(std::vector<double>& y) override { y = energy_.at(y).mean_edge_lengths(); }

 private:
  VolumeInAngles energy_;
};

std::unique_ptr<Functional> begin(const topology::Triangulation& triangulation,
                                  std::span<const topology::ConeAngle>,
                                  const InteriorAngles& angles, std::vector<double>& x) {
  const auto interior = angles();
  if (!interior) return nullptr;
  auto functional = std::make_unique<InAngles>(triangulation, *interior);
  x.assign(functional->problem().dimension(), 0.0);
  return functional;
}

}  // namespace

std::span<const Energy> volume() {
  // The gradient is a mismatch of lengths; a curvature adds the angles of up to dozens of corners.
  static constexpr Energy kRows[] = {
      {.name = "volume",
       .description =
           "minus twice the volume over the angle structures; its gradient: mismatch of lengths",
       .variables = "dihedral angles",
       .prefix = "angles:",
       .hyperideal_only = true,
       .tolerance = 1.0 / 8,
       .begin = begin,
       .place = 1}};
  return kRows;
}

}  // namespace tripus::energies::registered_energies
