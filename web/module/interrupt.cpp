// cli/interrupt.hpp where there are no signals and no timers: whoever runs the module may be asked
// whether to stop, and is asked where work looks at the clock. There is one thread.
#include "cli/interrupt.hpp"

#include <algorithm>
#include <ctime>
#include <optional>

#include <emscripten.h>
#include <fmt/format.h>

#include "cli/output.hpp"
#include "web/module/javascript.hpp"

namespace tripus::cli {
namespace {

using Clock = Context::Clock;

constexpr double kLongestLimit = 1e9;  // seconds: thirty years

struct StopState {
  std::atomic<bool> stop{false};
  std::optional<Clock::time_point> deadline;
  std::optional<Clock::time_point> deadline_of_line;
  double limit = 0;  ///< seconds; 0: none
  bool is_for_each_line = false;
};

StopState& state() {
  static StopState only;
  return only;
}

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(std::min(seconds, kLongestLimit)));
}

}  // namespace

/// A new run begins.
void catch_interrupts() {
  state().stop = false;
  state().deadline.reset();
  state().deadline_of_line.reset();
  state().limit = 0;
  state().is_for_each_line = false;
}

void set_time_limit(double seconds, bool each_line) {
  state().limit = seconds;
  state().is_for_each_line = each_line;
  if (!each_line) state().deadline = after(seconds);
}

LineLimit::LineLimit() {
  if (state().is_for_each_line) state().deadline_of_line = after(state().limit);
}
LineLimit::~LineLimit() { state().deadline_of_line.reset(); }

const std::atomic<bool>& interrupt_requested() { return state().stop; }
const std::atomic<bool>& stop_flag() { return state().stop; }
bool is_work_over() { return state().stop || interruptible().expired(); }
bool is_time_over() { return !state().stop && interruptible().expired(); }

std::string stop_text() {
  return is_time_over() ? fmt::format("the time limit of {} s was reached", state().limit)
                        : "interrupted";
}

double seconds_left() { return interruptible().seconds_left(); }

/// Nobody ends the work from outside, so that there is always time for an answer.
void set_last_words(std::string_view,
                    const std::function<std::string(std::string_view why, bool is_time_over)>&) {}

Context interruptible() {
  Context context;
  context.stop_flag = &state().stop;
  // One is always set: who works then looks at the clock, and the clock polls.
  context.deadline = state().deadline_of_line ? state().deadline_of_line
                     : state().deadline       ? state().deadline
                                              : after(kLongestLimit);
  context.threads = 1;
  context.progress = web::tell_progress;
  context.note = [](const std::string& note) { write_message("tripus: note: " + note + "\n"); };
  return context;
}

}  // namespace tripus::cli

namespace tripus::web {

void poll(double milliseconds) {
  constexpr double kPause = 50;
  static double next = 0;
  if (milliseconds < next) return;
  next = milliseconds + kPause;
  if (!cli::state().stop && stop_wanted()) cli::state().stop = true;
}

}  // namespace tripus::web

/// The C library's clock, in its place.
extern "C" int clock_gettime(clockid_t clock, timespec* time) {
  const double milliseconds =
      clock == CLOCK_REALTIME ? EM_ASM_DOUBLE({ return Date.now(); }) : emscripten_get_now();
  if (clock != CLOCK_REALTIME) tripus::web::poll(milliseconds);
  const double seconds = __builtin_floor(milliseconds / 1000);
  time->tv_sec = static_cast<time_t>(seconds);
  time->tv_nsec = static_cast<long>((milliseconds - seconds * 1000) * 1e6);
  return 0;
}
