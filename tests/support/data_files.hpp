#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/data_folder.hpp"

/// The files of data/.
namespace tripus::testing {

inline std::string data_text(const std::string& file) {
  std::ifstream in(data_folder() + "/" + file, std::ios::binary);
  if (!in) throw std::runtime_error("no data file " + file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The lines that are neither empty nor comments.
inline std::vector<std::string> data_lines(const std::string& file) {
  std::istringstream in(data_text(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') lines.push_back(line);
  return lines;
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

/// Rows of a table with tabs, by the names in its first line.
using Row = std::map<std::string, std::string>;
inline std::vector<Row> data_table(const std::string& file) {
  const std::vector<std::string> lines = data_lines(file);
  const std::vector<std::string> names = split(lines.at(0), '\t');
  std::vector<Row> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], '\t');
    Row row;
    for (std::size_t c = 0; c < names.size(); ++c) row[names[c]] = c < cells.size() ? cells[c] : "";
    rows.push_back(row);
  }
  return rows;
}

/// The 158 manifolds of manifolds-2-3.tsv with compact boundary (one more has a cusp).
inline std::vector<Row> compact_manifolds() {
  std::vector<Row> rows = data_table("manifolds-2-3.tsv");
  std::erase_if(rows,
                [](const Row& row) { return row.at("boundary").find('T') != std::string::npos; });
  return rows;
}

}  // namespace tripus::testing
