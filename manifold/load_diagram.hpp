#pragma once

#include <string>

#include "topology/diagrams/read_diagram.hpp"

namespace tripus {

/// The diagram that an INPUT is: a name of the shipped tables, a diagram as typed, a file with one,
/// or `-`. Throws InvalidInput if it is none or cannot be read.
topology::NamedDiagram load_diagram(const std::string& input);

}  // namespace tripus
