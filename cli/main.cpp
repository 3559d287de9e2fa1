#include <algorithm>
#include <string_view>

#include <sys/resource.h>
#include <unistd.h>

#include "cli/program.hpp"
#include "cli/streams.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TRIPUS_ADDRESS_SANITIZER 1  // which must run before all else, and without such limits
#endif
#endif

#ifndef TRIPUS_ADDRESS_SANITIZER
namespace {

/// OpenBLAS starts a thread a core when it is loaded, each with its share of the address space. It
/// ends the process where one does not come up, or waits for it for ever at the end. So where the
/// address space is limited the program begins anew with one thread asked for, before any library
/// is initialised: no allocation here.
void ask_for_one_blas_thread(int, char** argv, char** environment) {
  constexpr std::string_view kThreads = "OPENBLAS_NUM_THREADS=";
  constexpr std::size_t kMostVariables = 4096;
  static char one_thread[] = "OPENBLAS_NUM_THREADS=1";
  static char* extended[kMostVariables + 2];
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return;
  std::size_t count = 0;
  for (; environment[count] != nullptr; ++count) {
    if (count == kMostVariables || std::string_view(environment[count]).starts_with(kThreads))
      return;
    extended[count] = environment[count];
  }
  extended[count] = one_thread;
  ::execve("/proc/self/exe", argv, extended);  // where there is no such file, as if nothing was
}

[[gnu::used,
  gnu::section(".preinit_array")]] void (*const before_libraries)(int, char**,
                                                                  char**) = ask_for_one_blas_thread;

}  // namespace
#endif

int main(int argc, char** argv) {
  tripus::cli::secure_standard_streams();
  tripus::cli::tame_libraries();
  return tripus::cli::run_program({argv + std::min(argc, 1), argv + argc});
}
