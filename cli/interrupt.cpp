#include "cli/interrupt.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>

#include <unistd.h>

#include "cli/exit_status.hpp"
#include "cli/output.hpp"

namespace tripus::cli {
namespace {

/// How long work may take to end by itself. A second is promised; the rest is for the system.
constexpr long kGraceNanoseconds = 650'000'000;

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler needs it");

struct LastWords {
  std::string message = "tripus: interrupted; there is no answer yet\n";
  std::string output;
};
// A handler may read one while the other is written, and even while the process ends: so they are
// never destroyed.
std::array<LastWords, 2>& last_words = *new std::array<LastWords, 2>;
std::atomic<std::size_t> spoken{0};

timer_t grace{};
bool has_timer = false;

void say(int stream, const std::string& text) {
  [[maybe_unused]] const ssize_t written = ::write(stream, text.data(), text.size());
}

void on_grace_over(int) {
  const LastWords& words = last_words[spoken.load()];
  say(STDOUT_FILENO, words.output);
  say(STDERR_FILENO, words.message);
  std::_Exit(kNoAnswer);
}

void on_signal(int signal) {
  requested = true;
  std::signal(signal, SIG_DFL);
  itimerspec wait{};
  wait.it_value.tv_nsec = kGraceNanoseconds;
  if (has_timer) ::timer_settime(grace, 0, &wait, nullptr);
}

}  // namespace

const std::atomic<bool>& interrupt_requested() { return requested; }

void catch_interrupts() {
  static const bool installed = [] {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    std::signal(SIGALRM, on_grace_over);
    has_timer = ::timer_create(CLOCK_MONOTONIC, &event, &grace) == 0;
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return true;
  }();
  (void)installed;
}

void set_last_words(std::string message, std::string output) {
  const std::size_t next = 1 - spoken.load();
  last_words[next] = {std::move(message), std::move(output)};
  spoken = next;
}

Context interruptible() {
  Context context;
  context.stop_flag = &requested;
  context.note = [](const std::string& note) { write_message("tripus: note: " + note + "\n"); };
  return context;
}

}  // namespace tripus::cli
