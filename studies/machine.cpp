#include "studies/machine.hpp"

#include <algorithm>
#include <fstream>

#include "base/threads.hpp"

namespace tripus::studies {

Machine this_machine() {
  Machine machine{"unknown", thread_count(0), "unknown"};
#if defined(__clang__)
  machine.compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
  machine.compiler = "gcc " __VERSION__;
#endif
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      machine.processor = line.substr(colon + 2);
      break;
    }
  }
  return machine;
}

}  // namespace tripus::studies
