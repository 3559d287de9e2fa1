// The module's interface to JavaScript, in C: run the program, take what it wrote.
#include <algorithm>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <emscripten.h>

#include "base/version.hpp"
#include "cli/failure.hpp"
#include "cli/output.hpp"
#include "cli/program.hpp"
#include "cli/progress.hpp"
#include "cli/streams.hpp"
#include "web/module/javascript.hpp"

namespace {

struct Written {
  std::string output, messages;
};

Written& written() {
  static Written only;
  return only;
}

}  // namespace

// clang-format off
EM_JS(int, tripus_js_stop, (), { return Module["tripusStop"] && Module["tripusStop"]() ? 1 : 0; });
EM_JS(void, tripus_js_progress, (const char* text, int size, double tetrahedra), {
  if (Module["tripusProgress"]) Module["tripusProgress"](text, size, tetrahedra);
});
// clang-format on

namespace tripus::web {

bool stop_wanted() { return tripus_js_stop() != 0; }

void tell_progress(std::string_view activity, std::size_t tetrahedra) {
  constexpr double kPause = 100;
  static double next = 0;
  const double now = emscripten_get_now();
  if (now < next) return;
  next = now + kPause;
  tripus_js_progress(activity.data(), static_cast<int>(activity.size()),
                     static_cast<double>(tetrahedra));
}

}  // namespace tripus::web

namespace tripus::cli {

void write_output(std::string_view text) { written().output += text; }
void flush_output() {}
void write_message(std::string_view text) { written().messages += text; }

void secure_standard_streams() {}
void tame_libraries() {}

Progress::Progress(bool wanted)
    : enabled_(wanted), next_(std::chrono::steady_clock::now() + std::chrono::milliseconds(100)) {}
Progress::~Progress() = default;
bool Progress::due() { return enabled_ && std::chrono::steady_clock::now() >= next_; }
void Progress::show(const std::string& line) {
  web::tell_progress(line, 0);
  shown_ = true;
  next_ = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
}

}  // namespace tripus::cli

extern "C" {

/// Runs the program with `size` bytes of arguments, each ended by a 0. Returns its exit status.
/// What it wrote is there until the next run.
EMSCRIPTEN_KEEPALIVE int tripus_run(const char* arguments, int size) {
  written() = {};
  std::vector<std::string> given;
  const std::string_view all(arguments, static_cast<std::size_t>(size));
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find('\0', at), all.size());
    given.emplace_back(all.substr(at, end - at));
    at = end + 1;
  }
  try {
    return tripus::cli::run_program(given);
  } catch (...) {
    return tripus::cli::kInternalFailure;
  }
}
EMSCRIPTEN_KEEPALIVE const char* tripus_output() { return written().output.data(); }
EMSCRIPTEN_KEEPALIVE int tripus_output_size() { return static_cast<int>(written().output.size()); }
EMSCRIPTEN_KEEPALIVE const char* tripus_messages() { return written().messages.data(); }
EMSCRIPTEN_KEEPALIVE int tripus_messages_size() {
  return static_cast<int>(written().messages.size());
}
EMSCRIPTEN_KEEPALIVE const char* tripus_version() { return tripus::kVersion; }

}  // extern "C"
