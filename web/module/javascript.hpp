#pragma once

#include <cstddef>
#include <string_view>

namespace tripus::web {

/// Asks the caller of the module whether to stop.
bool stop_wanted();
/// Tells the caller what is going on.
void tell_progress(std::string_view activity, std::size_t tetrahedra);

/// Looks at the time, and at most some twenty times a second asks `stop_wanted`; sets the flag that
/// work polls. Called where work looks at the clock.
void poll(double milliseconds);

}  // namespace tripus::web
