#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// A gluing table as a file gives it. Consistent (see require_consistent), but possibly with open
/// faces, disconnected or empty: the constructor of Triangulation and require_solvable decide.
struct NamedGluings {
  std::string name;  ///< empty if the file has none
  Gluings gluings;
  std::vector<ConeAngle> cone_angles = {};  ///< [E] of Triangulation(gluings); empty if unlabelled
};

enum class TextFormat {
  kIsosig,
  kJson,
  kSnappea,
  kOrb,
  kReginaXml,
  kReginaTable,
  kGzip,     ///< recognised in order to be refused with advice
  kUnknown,  ///< none of these
};

/// Recognises the format by content alone. Cheap: looks at the first line or two, except that
/// kIsosig and kReginaTable need a scan of the text.
TextFormat detect_format(std::string_view text);

/// The name by which messages and documentation call the format.
std::string_view format_name(TextFormat format);

/// Reads a triangulation in whatever format the text has.
/// Throws InvalidInput saying what is wrong and where, or which formats there are.
NamedGluings read_triangulation(std::string_view text);

/// One input of a batch file.
struct BatchLine {
  std::size_t line_number = 0;  ///< from 1
  std::string text;             ///< without comment and surrounding white space; not empty
};

/// The lines of a batch file that hold something. A comment runs from a # at the start of a line
/// or after white space to the end of the line. Never throws.
std::vector<BatchLine> read_batch(std::string_view text);

}  // namespace tripus::topology
