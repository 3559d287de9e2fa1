#pragma once

#include <string_view>

#include "topology/diagrams/tables.hpp"

namespace tripus::topology::detail {

/// The text of a table as data/ has it: name, crossings, nodes.
std::string_view shipped_table_text(DiagramTable table);

}  // namespace tripus::topology::detail
