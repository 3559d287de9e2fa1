#include "cli/embedding_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/tolerances.hpp"
#include "cli/report_text.hpp"
#include "embedding/holonomy.hpp"

namespace tripus::cli {
namespace {

using embedding::Cell;
using embedding::CoverEnd;
using embedding::HyperboloidTetrahedron;
using embedding::Matrix4;
using embedding::Vector4;

void append_vector(JsonText& out, const Vector4& vector) {
  append_numbers(out, {vector.data(), 4});
}

/// Row by row.
void append_matrix(JsonText& out, const Matrix4& matrix) {
  const Matrix4 columns = matrix.transpose();
  append_numbers(out, {columns.data(), 16});
}

void append_tetrahedron(JsonText& out, const HyperboloidTetrahedron& tetrahedron) {
  append(out, "{\"vertices\": ");
  append_array(out, tetrahedron.vertices, append_vector);
  append(out, ", \"faces\": ");
  append_array(out, tetrahedron.faces, append_vector);
  out.push_back('}');
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// How well the relators hold in the frame of tetrahedron 0.
struct RelatorNumbers {
  double defect, bound;
  bool hold() const { return defect <= tolerance::kRelator; }
};

RelatorNumbers relator_numbers(const embedding::Holonomy& holonomy) {
  return {largest(embedding::relator_defects(holonomy)),
          largest(embedding::relator_bounds(holonomy))};
}

constexpr std::string_view kNotHeld =
    "do not hold in double precision in the frame of tetrahedron 0: the fundamental domain is too "
    "large for that; use face_pairings, which are exact to local_defect";

/// JSON has no infinity: null.
void append_finite(JsonText& out, double value) {
  if (std::isfinite(value)) {
    fmt::format_to(std::back_inserter(out), "{}", value);
  } else {
    append(out, "null");
  }
}

void append_generators(JsonText& out, const embedding::Holonomy& holonomy) {
  const auto& letters = holonomy.group.face_letters;
  append(out, "[");
  bool first = true;
  for (std::size_t slot = 0; slot < letters.size(); ++slot) {
    if (letters[slot] <= 0) continue;
    const std::size_t g = topology::generator_of(letters[slot]);
    const geometry::MoebiusMap& map = holonomy.moebius[g];
    if (!first) append(out, ", ");
    first = false;
    fmt::format_to(std::back_inserter(out),
                   "{{\"tetrahedron\": {}, \"face\": {}, \"isometry\": ", slot / 4, slot % 4);
    append_matrix(out, holonomy.isometries[g]);
    append(out, ", \"moebius\": ");
    append_array(out, std::array{map.a, map.b, map.c, map.d},
                 [](JsonText& to, const geometry::Complex& w) {
                   append_numbers(to, std::array{w.real(), w.imag()});
                 });
    fmt::format_to(std::back_inserter(out), ", \"reverses_orientation\": {}}}", map.reverses);
  }
  append(out, "]");
}

void append_holonomy(JsonText& out, const embedding::Holonomy& holonomy) {
  append(out, "{\"generators\": ");
  append_generators(out, holonomy);
  append(out, ", \"relators\": ");
  append_array(out, holonomy.group.presentation.relators,
               [](JsonText& to, const topology::Word& word) {
                 append_array(to, word, [](JsonText& text, topology::Letter letter) {
                   fmt::format_to(std::back_inserter(text), "{}", letter);
                 });
               });
  const RelatorNumbers numbers = relator_numbers(holonomy);
  append(out, ", \"relator_defect\": ");
  append_finite(out, numbers.defect);
  append(out, ", \"relator_bound\": ");
  append_finite(out, numbers.bound);
  append(out, ", \"local_defect\": ");
  append_finite(out, holonomy.local_defect);
  append(out, ", \"warning\": ");
  append(out, numbers.hold() ? "null" : fmt::format("\"the relators {}\"", kNotHeld));
  out.push_back('}');
}

void append_cell(JsonText& out, const Cell& cell) {
  fmt::format_to(std::back_inserter(out),
                 "{{\"tetrahedron\": {}, \"isometry\": ", cell.tetrahedron);
  append_matrix(out, cell.isometry);
  fmt::format_to(std::back_inserter(out), ", \"depth\": {}, \"parent\": ", cell.depth);
  if (cell.parent == embedding::kNoCell) {
    append(out, "null}");
  } else {
    fmt::format_to(std::back_inserter(out), "{}}}", cell.parent);
  }
}

/// Why there are no more cells than these, in one word.
std::string_view end_word(CoverEnd end) {
  switch (end) {
    case CoverEnd::kComplete:
      return "complete";
    case CoverEnd::kCells:
      return "cells";
    case CoverEnd::kInterrupted:
      return "interrupted";
    case CoverEnd::kPrecision:
      break;
  }
  return "precision";
}

std::string_view end_remark(CoverEnd end) {
  switch (end) {
    case CoverEnd::kComplete:
      break;
    case CoverEnd::kCells:
      return ": no more are grown; what was asked for is not complete";
    case CoverEnd::kInterrupted:
      return ": interrupted, what was asked for is not complete";
    case CoverEnd::kPrecision:
      return ": further out, double precision cannot tell cells apart; what was asked for is not "
             "complete";
  }
  return "";
}

}  // namespace

std::string embedding_as_json(const EmbeddedSubject& embedded) {
  JsonText out;
  std::string report = report_as_json(embedded.subject, embedded.report);
  report.pop_back();  // its closing brace: more keys follow
  append(out, report);
  append(out, ", \"tetrahedra\": ");
  append_array(out, embedded.embedding.tetrahedra, append_tetrahedron);
  append(out, ", \"face_pairings\": ");
  append_array(out, embedded.embedding.face_pairings,
               [](JsonText& to, const auto& four) { append_array(to, four, append_matrix); });
  append(out, ", \"holonomy\": ");
  append_holonomy(out, embedding::holonomy(embedded.embedding, embedded.subject.triangulation));
  append(out, ", \"cells\": ");
  append_array(out, embedded.cover.cells, append_cell);
  fmt::format_to(std::back_inserter(out), ", \"cells_end\": \"{}\"}}",
                 end_word(embedded.cover.end));
  return fmt::to_string(out);
}

std::string embedding_as_text(const EmbeddedSubject& embedded, const std::string& output) {
  const topology::Triangulation& triangulation = embedded.subject.triangulation;
  const embedding::Holonomy holonomy = embedding::holonomy(embedded.embedding, triangulation);
  std::string text = fmt::format("{}: embedded\n", printable(embedded.subject.input));
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<16}{}\n", label, value);
  };
  line("triangulation", one_line(triangulation));
  line("volume", fmt::format("{}", embedded.report.volume));
  line("around edges",
       fmt::format("the face pairings multiply to the identity within {:.1e}",
                   largest(embedding::edge_defects(embedded.embedding, triangulation))));
  const RelatorNumbers numbers = relator_numbers(holonomy);
  line("holonomy",
       fmt::format("{} in {}, relators {} {:.1e} (bound {:.1e})",
                   counted(holonomy.isometries.size(), "generator", "generators"),
                   holonomy.orientable ? "PSL(2,C)"
                                       : "O+(3,1); some reverse orientation, so not in PSL(2,C)",
                   numbers.hold() ? "hold within" : "miss the identity by", numbers.defect,
                   numbers.bound));
  if (!numbers.hold()) line("warning", fmt::format("the relators {}", kNotHeld));
  line("cells", fmt::format("{}{}", embedded.cover.cells.size(), end_remark(embedded.cover.end)));
  line("written to", printable(output));
  return text;
}

}  // namespace tripus::cli
