// Minimises the co-volume of the tripus over its one edge length, and reads off the metric.
#include <cmath>
#include <cstdio>
#include <vector>

#include "energies/co_volume.hpp"
#include "solver/method.hpp"
#include "topology/isosig.hpp"

int main() {
  using namespace tripus;
  const topology::Triangulation tripus_manifold(topology::decode_isosig("cPcbbbihq"));
  const energies::CoVolume energy(tripus_manifold);
  std::vector<double> x(energy.dimension(), 1.0);
  solver::find_method("newton")->minimise(energy, x, {});
  const auto at = energy.at(x);  // its gradient is -K, the edge curvatures
  std::printf("length %.15f, volume %.15f, K %.1e\n", x[0], at.volume(), -at.gradient()[0]);
  return std::fabs(at.volume() - 6.4519902708350328) < 1e-12 ? 0 : 1;
}
