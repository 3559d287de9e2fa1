#pragma once

namespace tripus::solver::detail {

/// Ceres reports troubles of its line search through glog, whatever its logging_type, and glog
/// writes to standard error. Raises glog's threshold to fatal errors, once, unless the program has
/// initialised glog and so decides for itself.
void silence_ceres();

}  // namespace tripus::solver::detail
