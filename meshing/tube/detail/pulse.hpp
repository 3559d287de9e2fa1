#pragma once

#include <functional>
#include <utility>

#include "base/stop.hpp"

namespace tripus::meshing::tube {

/// What long work calls now and then: throws Stopped when asked to, and shows that it goes on.
class Pulse {
 public:
  Pulse(const Stop& stop = {}, std::function<void()> beat = {})
      : stop_(stop), beat_(std::move(beat)) {}

  void operator()() const {
    throw_if_stopped(stop_);
    if (beat_) beat_();
  }

 private:
  Stop stop_;
  std::function<void()> beat_;
};

}  // namespace tripus::meshing::tube
