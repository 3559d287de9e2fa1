#pragma once

#include <string>
#include <string_view>

#include "embedding/universal_cover.hpp"
#include "manifold/subject.hpp"
#include "structure/report.hpp"

namespace tripus {

/// A metric in space: what `tripus embed` answers.
struct EmbeddedSubject {
  const Subject& subject;
  const structure::Report& report;
  embedding::Embedding embedding;
  embedding::UniversalCover cover;
};

/// The keys of solve, then tetrahedra, face_pairings, holonomy, cells and cells_end.
std::string embedding_as_json(const EmbeddedSubject& embedded);

/// Why there are no more cells than these, in one word: complete, cells, precision, interrupted.
std::string_view end_word(embedding::CoverEnd end);

/// What to say of relators that do not hold, after "the relators".
inline constexpr std::string_view kRelatorsDoNotHold =
    "do not hold in double precision in the frame of tetrahedron 0: the fundamental domain is too "
    "large for that; use face_pairings, which are exact to local_defect";

}  // namespace tripus
