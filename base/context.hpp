#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace tripus {

/// How long work is to be done: the last argument of everything that may take more than a moment.
///
/// A stop is no exception: what is done is returned, with the reason. Only where nothing is there
/// yet to be returned, as while an INPUT is read, it is reported as Stopped.
struct Context {
  using Clock = std::chrono::steady_clock;

  std::stop_token stop{};  ///< ends the work soon after a stop is requested
  /// The same for signal handlers, which may set a lock-free flag but must not call a stop source.
  const std::atomic<bool>* stop_flag = nullptr;
  std::optional<Clock::time_point> deadline{};  ///< when to end at the latest
  /// Called now and then, from the thread that does the work, with what is going on and how many
  /// tetrahedra there are so far (0: unknown).
  std::function<void(std::string_view activity, std::size_t tetrahedra)> progress{};
  /// Called with what was mended or left out of an input, in a sentence that names it; from any
  /// thread. Null: nobody wants to know.
  std::function<void(const std::string& note)> note{};
  unsigned threads = 0;  ///< for work that can be shared; 0: all cores

  bool stop_requested() const {
    return stop.stop_requested() ||
           (stop_flag != nullptr && stop_flag->load(std::memory_order_relaxed));
  }
  bool expired() const { return deadline && Clock::now() >= *deadline; }
  /// Seconds until the deadline, more than 0 also when it is over; infinity if there is none.
  double seconds_left() const;
  void report(std::string_view activity, std::size_t tetrahedra = 0) const {
    if (progress) progress(activity, tetrahedra);
  }
};

/// A Context's stop as the one flag that inner loops poll. Lives as long as the work.
class StopFlag {
 public:
  explicit StopFlag(const Context& context);
  StopFlag(const StopFlag&) = delete;
  StopFlag& operator=(const StopFlag&) = delete;

  const std::atomic<bool>* get() const { return flag_; }

 private:
  struct Raise {
    std::atomic<bool>* flag;
    void operator()() const { flag->store(true, std::memory_order_relaxed); }
  };
  std::atomic<bool> own_{false};
  const std::atomic<bool>* flag_ = nullptr;
  std::optional<std::stop_callback<Raise>> callback_;
};

}  // namespace tripus
