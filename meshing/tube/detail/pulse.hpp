#pragma once

#include <atomic>
#include <functional>
#include <utility>

#include "base/stopped.hpp"

namespace tripus::meshing::tube {

/// What long work calls now and then: throws Stopped when asked to, and shows that it goes on.
class Pulse {
 public:
  Pulse(const std::atomic<bool>* stop_requested = nullptr, std::function<void()> beat = {})
      : stop_requested_(stop_requested), beat_(std::move(beat)) {}

  void operator()() const {
    throw_if_stopped(stop_requested_);
    if (beat_) beat_();
  }

 private:
  const std::atomic<bool>* stop_requested_;
  std::function<void()> beat_;
};

}  // namespace tripus::meshing::tube
