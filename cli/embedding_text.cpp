#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "cli/describe.hpp"
#include "cli/interrupt.hpp"
#include "cli/texts.hpp"
#include "embedding/holonomy.hpp"

namespace tripus::cli {
namespace {

using embedding::CoverEnd;

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

constexpr std::string_view kRelatorsDoNotHold =
    "do not hold in double precision in the frame of tetrahedron 0: the fundamental domain is too "
    "large for that; use face_pairings, which are exact to local_defect";

std::string end_remark(CoverEnd end) {
  switch (end) {
    case CoverEnd::kComplete:
      break;
    case CoverEnd::kCells:
      return ": no more are grown; what was asked for is not complete";
    case CoverEnd::kInterrupted:
      return ": " + stop_text() + ", what was asked for is not complete";
    case CoverEnd::kPrecision:
      return ": further out, double precision cannot tell cells apart; what was asked for is not "
             "complete";
  }
  return "";
}

}  // namespace

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
  const embedding::RelatorDefect numbers = embedding::relator_defect(holonomy);
  line("holonomy",
       fmt::format("{} in {}, relators {} {:.1e} (bound {:.1e})",
                   counted(holonomy.isometries.size(), "generator", "generators"),
                   holonomy.orientable ? "PSL(2,C)"
                                       : "O+(3,1); some reverse orientation, so not in PSL(2,C)",
                   numbers.holds() ? "hold within" : "miss the identity by", numbers.defect,
                   numbers.bound));
  if (!numbers.holds()) line("warning", fmt::format("the relators {}", kRelatorsDoNotHold));
  line("cells", fmt::format("{}{}", embedded.cover.cells.size(), end_remark(embedded.cover.end)));
  line("written to", printable(output));
  return text;
}

}  // namespace tripus::cli
