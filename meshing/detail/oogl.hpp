#pragma once

#include "meshing/detail/scanner.hpp"

namespace tripus::meshing::detail {

/// To the keyword within what Geomview and its tools write around it: braces, "=", a name, a list
/// of one, how it looks. Returns whether there were braces.
bool skip_oogl_wrapping(Scanner& in);

}  // namespace tripus::meshing::detail
