#include "cli/interrupt.hpp"

#include <csignal>

#include "cli/output.hpp"

namespace tripus::cli {
namespace {

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler needs it");

void on_signal(int signal) {
  requested = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& interrupt_requested() { return requested; }

void catch_interrupts() {
  static const bool installed = [] {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return true;
  }();
  (void)installed;
}

Context interruptible() {
  Context context;
  context.stop_flag = &requested;
  context.progress = [](std::string_view, std::size_t) { catch_interrupts(); };
  context.note = [](const std::string& note) { write_message("tripus: note: " + note + "\n"); };
  return context;
}

}  // namespace tripus::cli
