#include "cli/streams.hpp"

#include <csignal>
#include <cstdlib>

#include <dlfcn.h>
#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cli/failure.hpp"

namespace tripus::cli {

void secure_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) != -1) continue;
    // The lowest free number is this one.
    const int got = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (got != stream) std::_Exit(kInternalFailure);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

void tame_libraries() {
#ifdef M_ARENA_MAX
  // Each thread reserves 128 MB for its heap; without them every allocation is a call of the
  // system.
  rlimit space{};
  const bool limited = ::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
  if (limited) ::mallopt(M_ARENA_MAX, 1);
#endif
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
  if (std::getenv("OPENBLAS_NUM_THREADS") != nullptr) return;
  ::setenv("OPENBLAS_NUM_THREADS", "1", 1);  // where it is loaded later, and where it is already:
  using SetThreads = void (*)(int);
  if (void* found = ::dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<SetThreads>(found)(1);
}

}  // namespace tripus::cli
