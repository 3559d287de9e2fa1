#pragma once

#include <atomic>
#include <csignal>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <nanobind/nanobind.h>

#include "base/context.hpp"

namespace tripus::python {

namespace nb = nanobind;

/// How long work may take, as Python says it.
struct Limits {
  std::optional<double> time_limit;
  unsigned threads = 0;
  nb::object progress;  ///< called with (activity, tetrahedra), or None
};

/// Work that a Python thread waits for without holding the interpreter's lock.
///
/// Ctrl-C: while the main thread works, a handler of ours comes before Python's and raises the flag
/// that the work polls. It costs two system calls, where a second thread to wait in would cost more
/// than a small solve.
///
/// Time limits: some work knows deadlines, all of it knows the flag, so a timer raises that a
/// moment later.
///
/// fork: a child has none of its parent's threads, but libgomp, which CHOLMOD uses, believes that
/// the forking thread still has its team, and waits for it for ever. A new thread has a new team,
/// so all work of a forked child is done in one.
class Work {
 public:
  explicit Work(const Limits& limits);
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  const Context& context() const { return context_; }
  /// Calls `work` without the lock, in a new thread if need be.
  void call(const std::function<void()>& work);
  /// With the lock held: throws what a progress callback or a signal handler threw. True if the
  /// work was cut short by a signal whose handler says to go on: it is to be done again.
  bool must_repeat();
  /// Rethrows what the work threw; Stopped with the time limit, if that stopped it.
  [[noreturn]] void rethrow(const std::exception_ptr& error) const;
  /// Notes on inputs become Python warnings.
  void warn() const;

 private:
  void report(std::string_view activity, std::size_t tetrahedra);
  void start_timer();

  Context context_;
  std::optional<double> time_limit_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> timed_out_{false};
  std::atomic<bool>* outer_ = nullptr;
  bool catches_ = false;
  struct sigaction previous_ {};
  nb::object progress_;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::string> notes_;
  std::jthread timer_;  ///< last: it ends before what it touches
};

/// Called once, by the thread that imports the module if it is the main one.
void prepare_for_work();

/// The result of work(context), which runs without the interpreter's lock.
template <class Function>
auto run(const Limits& limits, Function&& function) {
  using Result = std::invoke_result_t<Function&, const Context&>;
  Work work(limits);
  while (true) {
    std::optional<Result> result;
    std::exception_ptr error;
    work.call([&] {
      try {
        result.emplace(function(work.context()));
      } catch (...) {
        error = std::current_exception();
      }
    });
    if (work.must_repeat()) continue;
    if (error) work.rethrow(error);
    work.warn();
    return *std::move(result);
  }
}

/// The same for what is over soon: no limits, but the lock is let go all the same, as another
/// thread may be at the same value.
template <class Function>
auto quickly(Function&& function) {
  const nb::gil_scoped_release unlocked;
  return function();
}

}  // namespace tripus::python
