#include "cli/interrupt.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.hpp"
#include "cli/failure.hpp"
#include "cli/output.hpp"

namespace tripus::cli {
namespace {

using Nanoseconds = std::int64_t;  // of CLOCK_MONOTONIC

/// How long work may take to end by itself. A second is promised; the rest is for the system.
constexpr Nanoseconds kGrace = 650'000'000;
/// Work that knows its deadline may end by that, with better words, before its flag is raised.
constexpr Nanoseconds kGraceAfterDeadline = 100'000'000;
constexpr double kLongest = 1e9;  // seconds: thirty years

static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler needs it");
static_assert(std::atomic<Nanoseconds>::is_always_lock_free, "a signal handler needs it");

/// What ends at a time: the process, the time after its end, or a line of a batch. A handler may
/// look at one at any time, so they are never destroyed.
struct Alarm {
  std::atomic<bool> stop{false};
  std::atomic<bool> is_time_over{false};
  std::atomic<Nanoseconds> at{0};  ///< when the flag is raised; 0: never
  std::optional<Context::Clock::time_point> deadline;
  timer_t timer{};
  bool has_timer = false;
  std::atomic<bool> in_use{false};
  Alarm* next = nullptr;  ///< of the lines
};

Alarm& process = *new Alarm;
Alarm& grace = *new Alarm;
std::atomic<Alarm*> lines{nullptr};
thread_local Alarm* line = nullptr;  ///< of this thread

double limit = 0;  ///< seconds; 0: none
bool is_for_each_line = false;

Alarm& own() { return line != nullptr ? *line : process; }

struct LastWords {
  std::string message, output;
};
/// For both reasons; one can be read while the other is written, even while the process ends.
using Words = std::array<LastWords, 2>;
std::array<Words, 2>& last_words = *new std::array<Words, 2>;
std::atomic<std::size_t> spoken{0};

std::string why(bool is_time_over) {
  return is_time_over ? fmt::format("the time limit of {} s was reached", limit) : "interrupted";
}

Nanoseconds now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return Nanoseconds{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

void set(Alarm& alarm, Nanoseconds at) {
  alarm.at = at;
  itimerspec when{};
  when.it_value.tv_sec = at / 1'000'000'000;
  when.it_value.tv_nsec = at % 1'000'000'000;
  if (alarm.has_timer) ::timer_settime(alarm.timer, TIMER_ABSTIME, &when, nullptr);
}

void say(int stream, const std::string& text) {
  [[maybe_unused]] const ssize_t written = ::write(stream, text.data(), text.size());
}

[[noreturn]] void end_process() {
  const LastWords& words = last_words[spoken.load()][process.is_time_over ? 1 : 0];
  say(STDOUT_FILENO, words.output);
  say(STDERR_FILENO, words.message);
  std::_Exit(kNoAnswer);
}

void stop_process(bool is_time_over) {
  if (process.stop) return;
  process.is_time_over = is_time_over;
  process.stop = true;
  for (Alarm* each = lines; each != nullptr; each = each->next) each->stop = true;
  set(grace, now() + kGrace);
}

void on_signal(int signal) {
  std::signal(signal, SIG_DFL);
  stop_process(false);
}

void on_alarm(int, siginfo_t* info, void*) {
  const int error = errno;
  auto* alarm = static_cast<Alarm*>(info->si_value.sival_ptr);
  // One that was put off, or was for an earlier line, comes too soon.
  const bool is_due = alarm != nullptr && alarm->at != 0 && alarm->at <= now();
  if (is_due && alarm == &grace) end_process();
  if (is_due && alarm == &process) stop_process(true);
  if (is_due && alarm != &process && !alarm->stop) {
    alarm->is_time_over = true;
    alarm->stop = true;
  }
  errno = error;
}

void make_timer(Alarm& alarm) {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  event.sigev_value.sival_ptr = &alarm;
  alarm.has_timer = ::timer_create(CLOCK_MONOTONIC, &event, &alarm.timer) == 0;
}

/// Throws IoError if the system has no timer left.
void start(Alarm& alarm) {
  if (!alarm.has_timer) make_timer(alarm);
  if (!alarm.has_timer)
    throw IoError(std::string("--time-limit: no timer: ") + std::strerror(errno));
  alarm.deadline =
      Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(
                                  std::chrono::duration<double>(std::min(limit, kLongest)));
  set(alarm, now() + Nanoseconds(std::min(limit, kLongest) * 1e9) + kGraceAfterDeadline);
}

Alarm& free_line() {
  for (Alarm* each = lines; each != nullptr; each = each->next)
    if (!each->in_use.exchange(true)) return *each;
  auto* added = new Alarm;
  added->in_use = true;
  added->next = lines;
  while (!lines.compare_exchange_weak(added->next, added)) {
  }
  return *added;
}

}  // namespace

void catch_interrupts() {
  static const bool installed = [] {
    struct sigaction alarmed {};
    alarmed.sa_sigaction = on_alarm;
    alarmed.sa_flags = SA_SIGINFO | SA_RESTART;
    ::sigaction(SIGALRM, &alarmed, nullptr);
    make_timer(grace);
    set_last_words("; there is no answer yet");
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    return true;
  }();
  (void)installed;
}

void set_time_limit(double seconds, bool each_line) {
  catch_interrupts();
  limit = seconds;
  is_for_each_line = each_line;
  set_last_words("; there is no answer yet");
  if (!each_line) start(process);
}

LineLimit::LineLimit() {
  if (!is_for_each_line || limit == 0) return;
  Alarm& alarm = free_line();
  alarm.is_time_over = false;
  alarm.stop = false;
  if (process.stop) alarm.stop = true;  // a signal that comes later finds the line in the list
  line = &alarm;
  start(alarm);
}

LineLimit::~LineLimit() {
  if (line == nullptr) return;
  set(*line, 0);
  line->in_use = false;
  line = nullptr;
}

const std::atomic<bool>& interrupt_requested() { return process.stop; }

const std::atomic<bool>& stop_flag() { return own().stop; }

bool is_work_over() { return own().stop || interruptible().expired(); }

bool is_time_over() { return own().is_time_over || (!own().stop && interruptible().expired()); }

std::string stop_text() { return why(is_time_over()); }

double seconds_left() { return interruptible().seconds_left(); }

void set_last_words(
    std::string_view rest,
    const std::function<std::string(std::string_view why, bool is_time_over)>& output) {
  const std::size_t next = 1 - spoken.load();
  for (const bool over : {false, true}) {
    const std::string reason = why(over);
    last_words[next][over ? 1 : 0] = {fmt::format("tripus: {}{}\n", reason, rest),
                                      output ? output(reason, over) : ""};
  }
  spoken = next;
}

Context interruptible() {
  Context context;
  context.stop = &stop_flag();
  context.deadline = own().deadline;
  context.note = [](const std::string& note) { write_message("tripus: note: " + note + "\n"); };
  return context;
}

}  // namespace tripus::cli
