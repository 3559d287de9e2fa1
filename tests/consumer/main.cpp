// Prints the volume of the tripus.
#include <cstdio>

#include <tripus/tripus.hpp>

int main() {
  const auto M = tripus::load("cPcbbbihq");
  const auto* metric = M.metric();
  if (metric == nullptr) return 1;
  std::printf("%.17g\n", metric->volume());
}
