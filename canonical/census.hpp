#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canonical/canonize.hpp"

namespace tripus::canonical {

/// What a census says about a manifold.
struct CensusEntry {
  /// "t3g2.17" of the manifolds of the shipped census (tetrahedra, genera of the boundary, number);
  /// the signature of any other, which claims nothing and belongs to no other manifold.
  std::string name;
  std::size_t tetrahedra = 0;  ///< least number among `triangulations`
  std::string boundary;        ///< "g2", "g2+g3": genera of the components, ascending
  double volume = 0;
  std::string homology;                     ///< first homology, "2 Z + Z_3"
  std::string cells;                        ///< of the canonical decomposition, "4 tetrahedra"
  std::size_t keeping = 0, reversing = 0;   ///< isometries by what they do to the orientation
  std::string signature;                    ///< IsometrySignature::unoriented
  std::vector<std::string> triangulations;  ///< by isomorphism signature, shortest first

  friend bool operator==(const CensusEntry&, const CensusEntry&) = default;
};

/// Manifolds in the order of their names, and what is not one of them as far as was found.
struct Census {
  std::vector<CensusEntry> manifolds;
  std::vector<std::string> unresolved;  ///< triangulations; ascending
  /// So many digits of every volume after the point are proved, to half a unit of the last; all
  /// volumes are rounded to them. 0: volumes as they came out in floating point.
  int proved_digits = 0;

  /// By isometry signature or by the isomorphism signature of a listed triangulation, with or
  /// without a sign, or by name; null if there is none. Linear search.
  const CensusEntry* find(std::string_view text) const;
};

/// What became of one line of the list.
struct CensusLine {
  std::string triangulation;  ///< as listed
  bool resolved = false;
  bool own_metric = false;  ///< whether the triangulation itself carries it
  std::string reason;       ///< of an input that is refused: the error; else empty
  CensusEntry entry;        ///< if resolved: all but name, tetrahedra and triangulations
};

struct ClassifyOptions {
  CanonizeOptions canonize;
  unsigned threads = 0;  ///< 0: all cores
  /// Every line as soon as it is done, in any order, never from two threads at once.
  std::function<void(const CensusLine&)> on_line;
  const std::atomic<bool>* stop_requested = nullptr;
};

/// The budget that a census gives to retriangulation. Of the triangulations with 4 tetrahedra that
/// carry no metric themselves, all that are known to have a neighbour with one need a single move.
inline constexpr std::size_t kCensusBudget = 20;

/// Classifies triangulations, given by isomorphism signatures. When stopped, the lines so far.
std::vector<CensusLine> classify(const std::vector<std::string>& triangulations,
                                 const ClassifyOptions& options = {});

enum class CensusNames {
  kShipped,   ///< those of the shipped census; other manifolds are called by their signatures
  kNumbered,  ///< numbered anew: how the shipped census, which is complete, got its names
};

/// Sorts lines into manifolds: by tetrahedra, boundary (largest genus first), volume, signature;
/// and names them. The result does not depend on the order of the lines.
Census make_census(const std::vector<CensusLine>& lines, CensusNames names = CensusNames::kShipped);

/// Whether a text has the form of a shipped name, "t3g2.17".
bool is_census_name(std::string_view text);

/// One line of the journal that makes a census resumable, without the line end.
std::string to_journal(const CensusLine& line);

/// What it says; nothing if it is not such a line.
std::optional<CensusLine> parse_journal_line(std::string_view text);

/// The table: a comment with the counts, one where the volumes are proved, a header line, one
/// manifold a line; then a comment for
/// each unresolved triangulation, "# unresolved cPcbbbihq", with a surface behind it where the
/// triangulation shows one that no hyperbolic manifold has (structure::closed_bigon), and one with
/// a checksum for each line.
std::string to_tsv(const Census& census);
/// Line ends may be those of any system, and a table made by hand needs no comments. Throws
/// InvalidInput, naming the line; also for a line, a count or the digits of a volume that are not
/// as the comments say.
Census parse_tsv(std::string_view text);

/// A SQLite database with the tables manifold, triangulation, unresolved and about (the version,
/// the proved digits of the volumes, and the checksums of the lines), and the view hyperbolicity:
/// yes by a metric, no by a surface, or not decided. Both throw InvalidInput with the name of the
/// file and the library's reason, and IoError for what the system has failed in.
void write_database(const Census& census, const std::string& path);
Census read_database(const std::string& path);

/// The census that comes with the program: all with up to four tetrahedra.
const Census& shipped_census();

/// A choice of manifolds; what is empty or not set does not restrict. Spelling is free.
struct CensusQuery {
  double least_volume = 0;
  double greatest_volume = std::numeric_limits<double>::infinity();
  std::string boundary = {};  ///< see parse_boundary
  std::string homology = {};  ///< see topology::parse_abelian_group
  std::string cells = {};     ///< "4 tetrahedra", "pyramid + 2 tetrahedra"
  std::optional<std::size_t> tetrahedra = {};
};
/// Throws InvalidInput for a part of the query that cannot be read, and for an empty range of
/// volumes.
std::vector<const CensusEntry*> select(const Census& census, const CensusQuery& query);

/// Components of a boundary by their kinds.
struct BoundaryComponents {
  std::vector<std::size_t> genera;     ///< of geodesic components that are orientable
  std::vector<std::size_t> crosscaps;  ///< of those that are not: 2 - Euler characteristic
  std::size_t tori = 0, klein_bottles = 0;
};
/// "g2+g3", "g2+n3+T+K": ascending, cusps last.
std::string to_string(BoundaryComponents boundary);

/// "g2+g3" from "g3 + g2", "3,2", "genus 2 + genus 3"; "g2+T" from "torus + 2". Throws
/// InvalidInput.
std::string parse_boundary(std::string_view text);

/// Throws InvalidInput if a text does not describe cells: "2 tetrahedra + 1 pyramid".
void require_cells(std::string_view text);

/// What is in a census, in a sentence without full stop: numbers of tetrahedra, boundaries, ...
std::string describe(const Census& census);

}  // namespace tripus::canonical
