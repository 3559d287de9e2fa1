#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/stop.hpp"

namespace tripus {

/// How long work is to be done: the last argument of everything that may take more than a moment.
///
/// A stop is no exception: what is done is returned, with the reason. Only where nothing is there
/// yet to be returned, as while an INPUT is read, it is reported as Stopped.
struct Context {
  using Clock = std::chrono::steady_clock;

  Stop stop{};                                  ///< ends the work soon after it is requested
  std::optional<Clock::time_point> deadline{};  ///< when to end at the latest
  /// Called now and then, from the thread that does the work, with what is going on and how many
  /// tetrahedra there are so far (0: unknown).
  std::function<void(std::string_view activity, std::size_t tetrahedra)> progress{};
  /// Called with what was mended or left out of an input, in a sentence that names it; from any
  /// thread. Null: nobody wants to know.
  std::function<void(const std::string& note)> note{};
  unsigned threads = 0;  ///< for work that can be shared; 0: all cores

  bool stop_requested() const { return stop.requested(); }
  bool expired() const { return deadline && Clock::now() >= *deadline; }
  /// Seconds until the deadline, more than 0 also when it is over; infinity if there is none.
  double seconds_left() const;
  void report(std::string_view activity, std::size_t tetrahedra = 0) const {
    if (progress) progress(activity, tetrahedra);
  }
};

}  // namespace tripus
