#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/output_file.hpp"
#include "manifold/subject.hpp"
#include "structure/solve.hpp"
#include "topology/cone_angle.hpp"

namespace tripus::cli {

/// The history of a run as a CSV file, one row an iteration. Like every other file it comes to its
/// name when the run ends, interrupted or not; through a pipe the rows come as they are made.
class HistoryFile {
 public:
  /// Throws what OutputFile throws.
  explicit HistoryFile(const std::string& path);

  /// Throws IoError.
  void add(const structure::HistoryRow& row);
  /// Throws IoError if a row could not be written.
  void close() { file_.close(); }

 private:
  OutputFile file_;
  std::ostream& out_;
};

/// Edge lengths from a text: numbers separated by white space or commas with # comments, a JSON
/// array of numbers, or a JSON object with "edge_lengths", such as an answer of `tripus solve`.
/// Throws InvalidInput naming the line or the entry; the numbers themselves are not judged.
std::vector<double> parse_lengths(std::string_view text);

/// An angle in radians: "6.28", "2pi", "2pi/3", "pi/2".
/// Throws InvalidInput.
double parse_angle(std::string_view text);

/// Throws InvalidInput unless the name of an output file tells a format: .json (gluing table), .sig
/// (signature), .rga (Regina) or .tri (SnapPea). To be asked before the work.
void require_triangulation_name(const std::string& path);

/// Throws InvalidInput if there are cone angles and the format does not keep them: .json does.
void require_format_for(const std::string& path, std::span<const topology::ConeAngle> cone_angles);

/// Writes the triangulation in the format that the name tells, with a note on standard error where
/// it is a signature that tells no orientation. Throws InvalidInput if the file cannot be written,
/// or if the signature is wanted and not known, and as `require_format_for`.
void write_triangulation_file(const std::string& path, const Subject& subject);

}  // namespace tripus::cli
