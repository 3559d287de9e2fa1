#include "cli/streams.hpp"

#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <unistd.h>

#include "cli/exit_status.hpp"

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

}  // namespace tripus::cli
