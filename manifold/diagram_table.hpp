#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/context.hpp"
#include "manifold/json_text.hpp"
#include "topology/diagrams/tables.hpp"

namespace tripus {

/// What is known of the exterior of a shipped diagram. All but the name is computed from the
/// diagram.
struct DiagramRow {
  std::string name;
  std::size_t crossings = 0;       ///< of the diagram
  std::string boundary;            ///< genera of its components: "2", "1+1"
  std::string homology;            ///< "2 Z"
  std::string isosig;              ///< with its sign: carries the metric, if one was found
  std::size_t tetrahedra = 0;      ///< of `isosig`
  std::optional<bool> hyperbolic;  ///< nothing: not known
  bool proved = false;             ///< that it is hyperbolic, by interval arithmetic
  std::optional<double> volume;
  std::string signature;  ///< isometry signature; empty: not known
  std::string oriented_signature;
  std::size_t isometries = 0, reversing = 0;  ///< 0: not known
  std::string group;                          ///< "dihedral of order 6"
  std::vector<std::string> same_as;  ///< other names with the same exterior, orientation aside

  friend bool operator==(const DiagramRow&, const DiagramRow&) = default;
};

/// Simplifies, solves, proves, canonizes. Where the simplest triangulation carries no metric,
/// others are tried, within a budget. What a stop cut short is left empty.
DiagramRow diagram_row(const topology::TabledDiagram& diagram, const Context& context = {});

/// Fills in same_as, by the isometry signatures.
void mark_same(std::vector<DiagramRow>& rows);

/// The rows of a table that come with the library, computed by `tripus table NAME --compute`.
const std::vector<DiagramRow>& shipped_rows(topology::DiagramTable table);

/// A header line and one line a row, with tabs.
std::string to_tsv(const std::vector<DiagramRow>& rows);
/// Throws InvalidInput, naming the line.
std::vector<DiagramRow> parse_diagram_rows(std::string_view text);

/// {"name": ..., "diagram": [...], ...}.
void append_row(JsonText& out, const DiagramRow& row, const topology::Diagram& diagram);

/// A SQLite database with the table `diagram`. Throws InvalidInput with the library's reason.
void write_diagram_database(const std::vector<DiagramRow>& rows, const std::string& path);

}  // namespace tripus
