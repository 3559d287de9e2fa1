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
  std::vector<std::string> notes = {};      ///< what of the file was not read, in words for people
  /// Whether the labels mean an orientation. A signature without a sign says nothing about it.
  bool orientation_known = true;
};

enum class TextFormat {
  kIsosig,
  kJson,
  kSnappea,
  kOrb,
  kReginaXml,
  kReginaTable,
  kGzip,     ///< gzip-compressed, whatever is in it
  kUnknown,  ///< none of these
};

/// Recognises the format by content alone. Cheap: looks at the first line or two, except that
/// kIsosig and kReginaTable need a scan of the text.
TextFormat detect_format(std::string_view text);

/// The name by which messages and documentation call the format.
std::string_view format_name(TextFormat format);

/// The names of all formats, for messages: "JSON, SnapPea triangulation, ...".
std::string format_names();

/// Reads the one triangulation of a text in whatever format it has, also gzip-compressed.
/// Throws InvalidInput saying what is wrong and where, or which formats there are; Unsupported for
/// Dehn fillings.
NamedGluings read_triangulation(std::string_view text);

/// All triangulations of a text: several only of a Regina data file, which may hold any number.
/// Throws the same.
std::vector<NamedGluings> read_triangulations(std::string_view text);

/// The triangulation of that label among several, or else, if `label` is a number from 1, the one
/// at that place. Throws InvalidInput naming the labels if there is none, or if two have it.
NamedGluings pick_triangulation(std::vector<NamedGluings> all, std::string_view label);

/// The labels of several triangulations, for messages: "\"a\", \"b\" and 7 more".
std::string label_list(const std::vector<NamedGluings>& all);

/// One input of a batch file.
struct BatchLine {
  std::size_t line_number = 0;  ///< from 1
  std::string text;             ///< without comment and surrounding white space; not empty
};

/// The lines of a batch file that hold something. A comment runs from a # at the start of a line
/// or after white space to the end of the line; a line in quotes stands for what is within them.
/// Never throws.
std::vector<BatchLine> read_batch(std::string_view text);

}  // namespace tripus::topology
