#include "cli/progress.hpp"

#include <cstdio>

#include <unistd.h>

namespace tripus::cli {

Progress::Progress(bool wanted)
    : enabled_(wanted && isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + std::chrono::milliseconds(500)) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

bool Progress::due() { return enabled_ && std::chrono::steady_clock::now() >= next_; }

void Progress::show(const std::string& line) {
  std::fprintf(stderr, "\r\x1b[K%s", line.c_str());
  std::fflush(stderr);
  shown_ = true;
  next_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
}

}  // namespace tripus::cli
