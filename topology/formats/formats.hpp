#pragma once

#include <cstddef>
#include <optional>
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

/// Reads {"name": ..., "gluings": [[[1, "1230"], ...4 faces...], ...T tetrahedra...]}: for each
/// tetrahedron, for its faces 0..3, the other tetrahedron and the permutation p(0)p(1)p(2)p(3);
/// null for an open face. Other keys are ignored.
/// Throws InvalidInput naming tetrahedron and face, or the byte where the JSON breaks off.
NamedGluings read_json(std::string_view text);

/// One line, the inverse of read_json.
std::string write_json(const NamedGluings& triangulation);

/// Reads a file of Orb (or Casson), which begins with "% orb": the gluings and the cone orders of
/// its edges. What follows the rows of edges (lengths, angles, curves, a diagram) is not read.
/// Throws InvalidInput, naming the line and what was expected there.
NamedGluings read_orb(std::string_view text);

/// Writes the same: a row for each edge class, with its cone order and its corners in cyclic order,
/// and no solution. Colours number the singular edges from 1.
/// The tetrahedra are relabelled to agree in orientation, which the format needs.
/// Throws InvalidInput where the triangulation is not orientable, or a cone angle not known to be a
/// rational multiple of pi.
std::string write_orb(const NamedGluings& triangulation);

/// Reads all 3-manifold triangulations of an uncompressed Regina data file, in their order: of the
/// third generation (<tri dim="3">, Regina 7), the second (<packet type="3-Manifold
/// Triangulation">, in Regina 3 and 4 "Triangulation"), and SnapPea triangulations in either. Locks
/// and descriptions are skipped. Throws InvalidInput naming the tetrahedron and what was expected,
/// or the byte where the XML breaks off; if there is none; Unsupported for Dehn fillings. Source:
/// files written by Regina 4.5, 7.3 and 7.4.1.
std::vector<NamedGluings> read_regina_xml(std::string_view text);

/// Whether the first element of an XML text is one of Regina's.
bool starts_regina_xml(std::string_view text);

/// A data file of the third generation, uncompressed, with one triangulation.
std::string write_regina_xml(const NamedGluings& triangulation);

/// Reads the gluing table that Regina prints (`detail()`): the rows under "Tet | glued to:", "Tet |
/// gluing:" (7.4), or "Tet | face:", with entries like 1 (230) or "boundary". Throws InvalidInput
/// naming the line, tetrahedron and face.
NamedGluings read_regina_table(std::string_view text);

/// The table as Regina prints it. The name is not part of it.
std::string write_regina_table(const NamedGluings& triangulation);

/// Reads an isomorphism signature with what programs put behind it: SnapPy's decoration, from "_"
/// on (cPcbbbiht_BaCB), and Regina's locks, from "." on (cPcbbbihq.qa), which are skipped; Dehn
/// fillings as in cPcbbbiht_BaCB(1,2) are refused unless they are all (0,0). Throws what
/// decode_isosig throws; Unsupported for fillings.
NamedGluings read_signature(std::string_view text);

/// Whether a text, but for white space around it, looks like that.
bool looks_like_signature(std::string_view text);

/// Reads SnapPea's triangulation text ("% Triangulation"), as SnapPea, SnapPy, Regina and Orb
/// write it, also in free form, where lines mean nothing. Of each tetrahedron only the neighbours
/// and the permutations are read; peripheral curves and shapes are skipped. `//` starts a comment.
/// Throws InvalidInput naming the line, tetrahedron and face; Unsupported for Dehn fillings.
NamedGluings read_snappea(std::string_view text);

/// The file Regina would write: no cusps listed, structures left for the reader to compute.
/// Throws InvalidInput if a face is open: the format cannot say so.
std::string write_snappea(const NamedGluings& triangulation);

/// What a text is that names a manifold in the tables of another program (SnapPy's `m004`, `L5a1`,
/// `8_19`, `o9_00001`), and how to get its signature, in a sentence; nothing if it is no such name.
std::optional<std::string> foreign_name(std::string_view text);

}  // namespace tripus::topology
