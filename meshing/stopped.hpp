#pragma once

#include <atomic>

#include "base/error.hpp"

namespace tripus::meshing {

/// The caller asked for the end through `stop_requested`: there is nothing to return.
class Stopped : public Error {
 public:
  Stopped() : Error("interrupted") {}
};

inline void throw_if_stopped(const std::atomic<bool>* stop_requested) {
  if (stop_requested != nullptr && stop_requested->load(std::memory_order_relaxed)) throw Stopped();
}

}  // namespace tripus::meshing
