#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/registry.hpp"
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

/// One line of the table of formats.
struct Format {
  std::string_view name;  ///< by which messages and documentation call it
  /// Recognises it by content alone, given the text without surrounding white space, not empty.
  bool (*matches)(std::string_view text);
  /// All triangulations of the text; throws InvalidInput, Unsupported.
  std::vector<NamedGluings> (*read)(std::string_view text);
  int place = kAnyPlace;  ///< of two that match the lower is meant
};

/// Every format, one file in topology/formats each, in the order in which they are tried.
std::span<const Format> formats();

/// The reader of a format that holds one triangulation, as a Format has it.
template <NamedGluings (*Read)(std::string_view)>
std::vector<NamedGluings> read_one(std::string_view text) {
  std::vector<NamedGluings> all;
  all.push_back(Read(text));
  return all;
}

inline constexpr std::string_view kJson = "JSON", kReginaDataFile = "Regina data file",
                                  kIsomorphismSignature = "isomorphism signature",
                                  kGzip = "gzip data";

/// The name of the format, by content alone: kGzip whatever is compressed in it, empty for none.
/// Cheap: most look at the first line or two; signatures and Regina's tables need a scan.
std::string_view detect_format(std::string_view text);

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
