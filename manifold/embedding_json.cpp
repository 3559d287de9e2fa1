#include "manifold/embedding_json.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "embedding/holonomy.hpp"
#include "manifold/report_json.hpp"

namespace tripus {
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
  const embedding::RelatorDefect numbers = embedding::relator_defect(holonomy);
  append(out, ", \"relator_defect\": ");
  append_finite(out, numbers.defect);
  append(out, ", \"relator_bound\": ");
  append_finite(out, numbers.bound);
  append(out, ", \"local_defect\": ");
  append_finite(out, holonomy.local_defect);
  append(out, ", \"warning\": ");
  append(out, numbers.holds() ? "null" : fmt::format("\"the relators {}\"", kRelatorsDoNotHold));
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

}  // namespace tripus
