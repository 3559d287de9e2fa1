#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "topology/diagrams/diagram.hpp"
#include "topology/diagrams/read_diagram.hpp"

namespace tripus::topology {

/// The tables of diagrams that come with the library.
enum class DiagramTable : std::uint8_t { kKnots, kLinks, kThetaCurves, kHandlebodyKnots };
inline constexpr DiagramTable kDiagramTables[] = {DiagramTable::kKnots, DiagramTable::kLinks,
                                                  DiagramTable::kThetaCurves,
                                                  DiagramTable::kHandlebodyKnots};
/// "knots", "links", "theta-curves" (with the handcuff graphs), "handlebody-knots".
std::string_view table_name(DiagramTable table);
std::optional<DiagramTable> find_table(std::string_view name);

/// A diagram of a table.
struct TabledDiagram {
  std::string name;           ///< "8_19", "L5a1", "5_1 theta", "2_1 handcuff", "hk5_3"
  std::size_t crossings = 0;  ///< of the diagram; a few have more than their name says
  Diagram diagram;
};

/// The diagrams of a table in their order. Read once.
std::span<const TabledDiagram> table_of(DiagramTable table);

/// An entry of a table, and whether its mirror image is meant.
struct WantedDiagram {
  const TabledDiagram* entry = nullptr;  ///< null if there is none
  bool mirrored = false;
};

/// By name; blanks, underscores and capitals do not matter, and Moriuchi's T5_1 and H2_1 stand for
/// "5_1 theta" and "2_1 handcuff". Null if there is none.
const TabledDiagram* find_diagram(std::string_view name);

/// The same; "m(hk5_3)", "hk5_3m", "hk5_3*", "hk5_3 mirror" and "mirror hk5_3" mean mirror images.
WantedDiagram find_diagram_up_to_mirror(std::string_view name);

/// The same as a diagram with its name; mirror images are called "m(hk5_3)". Nothing if there is
/// none.
std::optional<NamedDiagram> find_diagram_or_mirror(std::string_view name);

/// Whether a text has the form of such a name: "hk9_9", "7_100", "L14n5", "8_1 theta", "hk9_9m".
bool is_diagram_name(std::string_view text);

/// Whether a text is a name of the tables but for a slip or two: "5_1 tehta".
bool is_nearly_diagram_name(std::string_view text);

/// The names nearest to one that is not there, for messages: "hk5_1, hk5_2, ...".
std::string nearest_diagram_names(std::string_view name, std::size_t count = 4);

}  // namespace tripus::topology
