#pragma once

#include <atomic>

#include "base/context.hpp"

namespace tripus::orthospectrum::detail {

/// Ends a search on all threads: when the caller wants it or the time is over.
class Halt {
 public:
  enum Reason : int { kNone, kCaller, kTime };

  explicit Halt(const Context& context) : context_(context) {}

  /// Asks; from then on every thread is told. Cheap enough for every few hundred microseconds.
  bool now() {
    if (reason_.load(std::memory_order_relaxed) != kNone) return true;
    if (context_.stop_requested()) {
      reason_ = kCaller;
    } else if (context_.expired()) {
      reason_ = kTime;
    }
    return reason_.load(std::memory_order_relaxed) != kNone;
  }
  /// For a thread that has failed.
  void stop() { reason_ = kCaller; }
  Reason reason() const { return static_cast<Reason>(reason_.load()); }

 private:
  const Context& context_;
  std::atomic<int> reason_{kNone};
};

}  // namespace tripus::orthospectrum::detail
