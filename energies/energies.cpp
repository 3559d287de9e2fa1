#include "energies/energies.hpp"

#include "energies/co_volume.hpp"

namespace tripus::energies {

std::unique_ptr<Functional> at_lengths(const Energy& energy,
                                       const topology::Triangulation& triangulation,
                                       std::vector<double>& x) {
  const auto angles = [&]() -> std::optional<std::vector<double>> {
    CoVolume co_volume(triangulation);
    std::vector<double> gradient(triangulation.edge_count());
    co_volume.evaluate(x, gradient, {});
    std::vector<double> all;
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      const auto theta = co_volume.dihedral_angles(t);
      all.insert(all.end(), theta.begin(), theta.end());
    }
    return all;
  };
  return energy.begin(triangulation, {}, angles, x);
}

}  // namespace tripus::energies
