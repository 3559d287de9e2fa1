#pragma once

#include <atomic>
#include <stop_token>
#include <utility>

#include "base/error.hpp"

namespace tripus {

/// Whether work is to end before it is done: what all that may take long polls. A value, cheap to
/// copy. By default nothing ends the work.
class Stop {
 public:
  Stop() = default;
  // Implicit, so that either is given as it is.
  Stop(std::stop_token token) : token_(std::move(token)) {}
  /// A flag, for signal handlers, which must not call a stop source; it must outlive the work.
  Stop(const std::atomic<bool>* flag) : flag_(flag) {}

  bool requested() const {
    return token_.stop_requested() || (flag_ != nullptr && flag_->load(std::memory_order_relaxed));
  }
  explicit operator bool() const { return requested(); }
  /// Whether anything can ever request it.
  bool possible() const { return flag_ != nullptr || token_.stop_possible(); }

 private:
  std::stop_token token_{};
  const std::atomic<bool>* flag_ = nullptr;
};

/// A stop was requested before there was anything to return.
class Stopped : public Error {
 public:
  Stopped() : Error("interrupted") {}
};

inline void throw_if_stopped(const Stop& stop) {
  if (stop.requested()) throw Stopped();
}

}  // namespace tripus
