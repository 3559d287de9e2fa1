#pragma once

#include <atomic>

#include "base/error.hpp"

namespace tripus {

/// A stop was requested before there was anything to return.
class Stopped : public Error {
 public:
  Stopped() : Error("interrupted") {}
};

inline void throw_if_stopped(const std::atomic<bool>* stop_requested) {
  if (stop_requested != nullptr && stop_requested->load(std::memory_order_relaxed)) throw Stopped();
}

}  // namespace tripus
