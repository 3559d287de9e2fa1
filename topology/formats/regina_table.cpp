#include <array>
#include <optional>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::topology {
namespace {

[[noreturn]] void fail(std::size_t line, const std::string& what) {
  throw InvalidInput("Regina gluing table, line " + std::to_string(line) + ": " + what);
}

/// The columns are the faces 012 013 023 123, opposite vertices 3, 2, 1, 0.
constexpr std::array<int, 4> kFaceOfColumn{3, 2, 1, 0};

bool is_header(std::string_view line) {
  return detail::trimmed(line).starts_with("Tet") && line.find('|') != std::string_view::npos &&
         (line.find("glued to:") != std::string_view::npos ||
          line.find("gluing:") != std::string_view::npos ||
          line.find("face:") != std::string_view::npos);
}

void require_known_columns(std::string_view header, std::size_t line) {
  std::string digits;
  for (const char c : header)
    if (c >= '0' && c <= '9') digits += c;
  if (digits != "012013023123")
    fail(line, "the columns are " + quoted(digits) + "; expected the faces 012 013 023 123");
}

/// "(230)" for a face with vertices a < b < c: the images of a, b, c.
std::optional<Perm4> parse_face_images(std::string_view token, int face) {
  if (token.size() != 5 || token.front() != '(' || token.back() != ')') return std::nullopt;
  std::string images;
  int sum = 6;
  std::size_t next = 1;
  for (int v = 0; v < 4; ++v) {
    if (v == face) {
      images += '?';
      continue;
    }
    const char c = token[next++];
    images += c;
    sum -= c - '0';
  }
  if (sum < 0 || sum > 3) return std::nullopt;
  images[static_cast<std::size_t>(face)] = static_cast<char>('0' + sum);
  return detail::parse_perm(images);
}

void read_row(std::string_view row, std::size_t line, std::size_t t, Gluings& gluings) {
  for (const int f : kFaceOfColumn) {
    const std::string face =
        "face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + ": ";
    const auto token = detail::take_token(row);
    if (token == "boundary") continue;
    const auto other = detail::parse_integer(token);
    if (!other || *other < 0 || *other >= static_cast<std::int64_t>(kMaxTetrahedra))
      fail(line, face + quoted(std::string(token)) + "; expected a tetrahedron or \"boundary\"");
    const auto images = detail::take_token(row);
    const auto perm = parse_face_images(images, f);
    if (!perm)
      fail(line, face + quoted(std::string(images)) +
                     "; expected the images of its three vertices, such as (230)");
    gluings.set_one_side(t, f, static_cast<TetrahedronIndex>(*other), *perm);
  }
  if (!detail::trimmed(row).empty())
    fail(line, "tetrahedron " + std::to_string(t) +
                   " has more than four faces: " + quoted(std::string(detail::trimmed(row))));
}

}  // namespace

NamedGluings read_regina_table(std::string_view text) {
  std::size_t line = 0;
  bool found = false;
  while (!text.empty() && !found) {
    const auto header = detail::take_line(text);
    ++line;
    found = is_header(header);
    if (found) require_known_columns(header, line);
  }
  if (!found)
    throw InvalidInput(
        "Regina gluing table: no header \"Tet | glued to: (012) (013) (023) "
        "(123)\"");
  NamedGluings result;
  while (!text.empty()) {
    const auto row = detail::take_line(text);
    ++line;
    if (detail::trimmed(row).starts_with("---")) continue;
    const std::size_t bar = row.find('|');
    if (bar == std::string_view::npos) break;
    const std::size_t t = result.gluings.tetrahedron_count();
    const auto label = detail::trimmed(row.substr(0, bar));
    if (detail::parse_integer(label) != static_cast<std::int64_t>(t))
      fail(line,
           "row " + quoted(std::string(label)) + "; expected tetrahedron " + std::to_string(t));
    result.gluings.resize(t + 1);
    read_row(row.substr(bar + 1), line, t, result.gluings);
  }
  require_consistent(result.gluings, OpenFaces::kAllowed);
  return result;
}

std::string write_regina_table(const NamedGluings& triangulation) {
  const Gluings& gluings = triangulation.gluings;
  std::string out =
      "  Tet  |  glued to:      (012)      (013)      (023)      (123)\n"
      "  -----+-------------------------------------------------------\n";
  const auto padded = [](const std::string& entry, std::size_t width) {
    return (entry.size() < width ? std::string(width - entry.size(), ' ') : " ") + entry;
  };
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
    out += padded(std::to_string(t), 5) + "  |           ";
    for (const int f : kFaceOfColumn) {
      std::string entry = "boundary";
      if (!gluings.is_open(t, f)) {
        entry = std::to_string(gluings.neighbour(t, f)) + " (";
        for (int v = 0; v < 4; ++v)
          if (v != f) entry += static_cast<char>('0' + gluings.gluing(t, f)(v));
        entry += ")";
      }
      out += padded(entry, 11);
    }
    out += "\n";
  }
  return out;
}

}  // namespace tripus::topology

namespace tripus::topology::registered_formats {
namespace {

bool holds_table(std::string_view text) {
  return text.find("glued to:") != std::string_view::npos ||
         text.find("|  gluing:") != std::string_view::npos ||
         (text.starts_with("Tet") && text.find("face:") != std::string_view::npos);
}

}  // namespace

std::span<const Format> regina_table() {
  static constexpr Format kRows[] = {
      {"Regina gluing table", holds_table, read_one<read_regina_table>, 4}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
