#pragma once

#include <atomic>
#include <chrono>

namespace tripus::orthospectrum::detail {

/// Ends a search on all threads: when the caller wants it or the time is over.
class Halt {
 public:
  enum Reason : int { kNone, kCaller, kTime };

  Halt(const std::atomic<bool>* requested, double seconds)
      : requested_(requested), limited_(seconds < kNoLimit) {
    if (limited_) {
      end_ = std::chrono::steady_clock::now() +
             std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                 std::chrono::duration<double>(seconds));
    }
  }

  /// Asks; from then on every thread is told. Cheap enough for every few hundred microseconds.
  bool now() {
    if (reason_.load(std::memory_order_relaxed) != kNone) return true;
    if (requested_ != nullptr && requested_->load(std::memory_order_relaxed)) {
      reason_ = kCaller;
    } else if (limited_ && std::chrono::steady_clock::now() >= end_) {
      reason_ = kTime;
    }
    return reason_.load(std::memory_order_relaxed) != kNone;
  }
  /// For a thread that has failed.
  void stop() { reason_ = kCaller; }
  Reason reason() const { return static_cast<Reason>(reason_.load()); }

 private:
  static constexpr double kNoLimit = 1e8;  // seconds: three years
  const std::atomic<bool>* requested_;
  bool limited_;
  std::chrono::steady_clock::time_point end_;
  std::atomic<int> reason_{kNone};
};

}  // namespace tripus::orthospectrum::detail
