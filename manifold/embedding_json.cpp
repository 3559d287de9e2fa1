#include "manifold/embedding_json.hpp"

#include <algorithm>
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
  append(out, ", \"kinds\": ");
  append_array(out, tetrahedron.diagonal, [](JsonText& to, double d) {
    append_string(to, d > 0 ? "hyperideal" : d == 0 ? "ideal" : "finite");
  });
  out.push_back('}');
}

void append_word(JsonText& out, const topology::Word& word) {
  append_array(out, word, [](JsonText& to, topology::Letter letter) {
    fmt::format_to(std::back_inserter(to), "{}", letter);
  });
}

/// null where an isometry carries farther than doubles reach.
void append_finite_matrix(JsonText& out, const Matrix4& matrix) {
  if (matrix.allFinite()) {
    append_matrix(out, matrix);
  } else {
    append(out, "null");
  }
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
    append_finite_matrix(out, holonomy.isometries[g]);
    append(out, ", \"moebius\": ");
    const std::array entries{map.a, map.b, map.c, map.d};
    const bool finite = std::ranges::all_of(entries, [](const geometry::Complex& w) {
      return std::isfinite(w.real()) && std::isfinite(w.imag());
    });
    if (finite) {
      append_array(out, entries, [](JsonText& to, const geometry::Complex& w) {
        append_numbers(to, std::array{w.real(), w.imag()});
      });
    } else {
      append(out, "null");
    }
    fmt::format_to(std::back_inserter(out), ", \"reverses_orientation\": {}}}", map.reverses);
  }
  append(out, "]");
}

void append_holonomy(JsonText& out, const embedding::Holonomy& holonomy) {
  append(out, "{\"generators\": ");
  append_generators(out, holonomy);
  append(out, ", \"relators\": ");
  append_array(out, holonomy.group.presentation.relators, append_word);
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

/// The deck transformation that carries a cell's tetrahedron from the fundamental domain of the
/// generators to the cell, freely reduced: exact, however far away that is.
topology::Word word_of(const std::vector<Cell>& cells, const Cell& cell,
                       const std::vector<topology::Letter>& face_letters) {
  topology::Word word;
  for (const Cell* at = &cell; at->parent != embedding::kNoCell; at = &cells[at->parent]) {
    const topology::Letter letter =
        face_letters[4 * std::size_t{cells[at->parent].tetrahedron} + at->face];
    if (letter == 0) continue;
    if (!word.empty() && word.back() == -letter) {
      word.pop_back();
    } else {
      word.push_back(letter);
    }
  }
  std::ranges::reverse(word);
  return word;
}

void append_cell(JsonText& out, const std::vector<Cell>& cells, const Cell& cell,
                 const std::vector<topology::Letter>& face_letters) {
  fmt::format_to(std::back_inserter(out),
                 "{{\"tetrahedron\": {}, \"isometry\": ", cell.tetrahedron);
  append_finite_matrix(out, cell.isometry);
  append(out, ", \"word\": ");
  append_word(out, word_of(cells, cell, face_letters));
  fmt::format_to(std::back_inserter(out), ", \"depth\": {}, \"parent\": ", cell.depth);
  if (cell.parent == embedding::kNoCell) {
    append(out, "null}");
  } else {
    fmt::format_to(std::back_inserter(out), "{}}}", cell.parent);
  }
}

}  // namespace

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
  append(out, ", \"horosphere_area\": ");
  if (embedded.embedding.horosphere_area > 0)
    append_finite(out, embedded.embedding.horosphere_area);
  else
    append(out, "null");
  append(out, ", \"holonomy\": ");
  const auto holonomy = embedding::holonomy(embedded.embedding, embedded.subject.triangulation);
  append_holonomy(out, holonomy);
  append(out, ", \"cells\": ");
  append_array(out, embedded.cover.cells, [&](JsonText& to, const Cell& cell) {
    append_cell(to, embedded.cover.cells, cell, holonomy.group.face_letters);
  });
  fmt::format_to(std::back_inserter(out), ", \"cells_end\": \"{}\"}}",
                 end_word(embedded.cover.end));
  return fmt::to_string(out);
}

}  // namespace tripus
