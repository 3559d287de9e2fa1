// From an INPUT to its metric, its name and its cells, by the front door.
#include <cstdio>

#include <tripus/tripus.hpp>

int main() {
  const auto M = tripus::load("cPcbbbihq");
  const auto* metric = M.metric();
  if (metric == nullptr) {
    std::puts(M.verdict().message.c_str());
    return 1;
  }
  std::printf("volume %.15g, H1 %s\n", metric->volume(), to_string(M.homology()).c_str());
  if (const auto* entry = M.identify()) std::printf("it is %s\n", entry->name.c_str());
  std::printf("%zu cells of the universal cover\n", metric->universal_cover(100).cells().size());
  return 0;
}
