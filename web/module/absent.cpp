// What the module has not: each function of a source that is left out (cmake/TripusLean.cmake) and
// is called by one that is not. They say what the program can do in their place.
#include "base/compression.hpp"
#include "base/error.hpp"
#include "canonical/census.hpp"
#include "manifold/diagram_table.hpp"
#include "orthospectrum/proved_lengths.hpp"
#include "structure/detail/other_ways.hpp"
#include "structure/proof/arc_lengths.hpp"
#include "structure/proof/canonical_proof_text.hpp"
#include "structure/proof/digits.hpp"
#include "structure/proof/prove_report.hpp"
#include "structure/proof/tilt_signs.hpp"

namespace tripus {
namespace {

[[noreturn]] void refuse_proof() { throw Unsupported("proofs need the program: tripus prove"); }

}  // namespace

bool is_gzip(std::string_view content) { return content.starts_with("\x1f\x8b"); }
std::string gunzip(std::string_view, std::size_t) {
  throw Unsupported("it is compressed by gzip; unpack it first");
}

void write_diagram_database(const std::vector<DiagramRow>&, const std::string&) {
  throw Unsupported("databases need the program: tripus table --database FILE");
}

namespace canonical {

Census read_database(const std::string&) {
  throw Unsupported("a census in a database needs the program; give it as a table with tabs");
}

}  // namespace canonical

namespace structure {

Proof prove(const topology::Triangulation&, std::span<const double>, const ProveOptions&,
            const Context&) {
  refuse_proof();
}
Proof prove_near(const topology::Triangulation&, std::span<const double>, const ProveOptions&,
                 const Context&) {
  refuse_proof();
}
ProofText proof_text(const Proof&, const Digits*) { refuse_proof(); }
Digits prove_digits(const topology::Triangulation&, const Proof&, int, const Context&) {
  refuse_proof();
}
ProofText prove_report(const topology::Triangulation&, const Report&, const ProveReportOptions&,
                       const Context&) {
  refuse_proof();
}
std::string proof_message(const ProofText&) { refuse_proof(); }
std::string to_json(const ProofText&) { refuse_proof(); }
std::vector<std::optional<Interval>> prove_arc_lengths(const topology::Triangulation&, const Proof&,
                                                       std::span<const ArcPath>, const Context&) {
  refuse_proof();
}
TiltSigns tilt_signs(const topology::Triangulation&, const Proof&, const TiltOptions&,
                     const Context&) {
  refuse_proof();
}
std::string to_json(const CanonicalProofText&) { refuse_proof(); }

namespace detail {

std::optional<Report> precise_minimiser(const topology::Triangulation&, const SolveOptions&,
                                        const Report& report) {
  Report unchanged = report;
  unchanged.message += " The program goes on from here with more digits: tripus solve.";
  return unchanged;
}

}  // namespace detail
}  // namespace structure
}  // namespace tripus
