#include "solver/detail/ceres_silence.hpp"

#include <mutex>

#include <glog/logging.h>

namespace tripus::solver::detail {

void silence_ceres() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (!google::IsGoogleLoggingInitialized()) FLAGS_minloglevel = google::FATAL;
  });
}

}  // namespace tripus::solver::detail
