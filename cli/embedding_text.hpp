#pragma once

#include <string>

#include "cli/describe.hpp"
#include "embedding/universal_cover.hpp"
#include "structure/report.hpp"

namespace tripus::cli {

/// A metric in space: what `tripus embed` answers.
struct EmbeddedSubject {
  const Subject& subject;
  const structure::Report& report;
  embedding::Embedding embedding;
  embedding::UniversalCover cover;
};

/// The keys of solve, then tetrahedra, face_pairings, holonomy, cells and cells_end.
std::string embedding_as_json(const EmbeddedSubject& embedded);

/// A few lines for people; `output` is the file written.
std::string embedding_as_text(const EmbeddedSubject& embedded, const std::string& output);

}  // namespace tripus::cli
