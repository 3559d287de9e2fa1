#include "energies/energies.hpp"

#include <array>
#include <vector>

#include "energies/co_volume.hpp"
#include "energies/volume_in_angles.hpp"

namespace tripus::energies {
namespace {

std::unique_ptr<solver::Problem> co_volume_at(const topology::Triangulation& triangulation,
                                              std::span<const double> lengths,
                                              std::vector<double>& x) {
  x.assign(lengths.begin(), lengths.end());
  return std::make_unique<CoVolume>(triangulation);
}

std::unique_ptr<solver::Problem> volume_at(const topology::Triangulation& triangulation,
                                           std::span<const double> lengths,
                                           std::vector<double>& x) {
  CoVolume co_volume(triangulation);
  std::vector<double> gradient(triangulation.edge_count());
  co_volume.evaluate(lengths, gradient, {});
  std::vector<double> angles;
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const auto theta = co_volume.dihedral_angles(t);
    angles.insert(angles.end(), theta.begin(), theta.end());
  }
  auto energy = std::make_unique<VolumeInAngles>(triangulation, angles);
  x.assign(energy->dimension(), 0.0);
  return energy;
}

constexpr std::array<Energy, 2> kEnergies{{
    {"co-volume", "sum of the tetrahedra's co-volumes less sum k_e l_e; its gradient is -K",
     "edge lengths", co_volume_at},
    {"volume",
     "minus twice the volume over the angle structures; its gradient: mismatch of lengths",
     "dihedral angles", volume_at},
}};

}  // namespace

std::span<const Energy> energies() { return kEnergies; }

}  // namespace tripus::energies
