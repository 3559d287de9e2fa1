// tripus check: is this a valid certificate or proof for this triangulation?
#include <memory>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/interrupt.hpp"
#include "cli/verb.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "manifold/subject.hpp"
#include "structure/certificate.hpp"
#include "structure/proof/canonical_proof_text.hpp"
#include "structure/proof/proof_text.hpp"

namespace tripus::cli {
namespace {

using structure::Certificate;

struct CheckOptions : CommonOptions {
  std::string certificate;
};

/// What `parse` makes of a text; its errors name the file.
template <class Parse>
auto parse_file(const std::string& path, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput((path == "-" ? "standard input" : quoted(path)) + ": " + error.what());
  }
}

std::string proof_verdict(const structure::ProofText& proof, const structure::ProofCheck& result) {
  if (!result) return "not valid: " + result.reason;
  return proof.claim == structure::Proof::Claim::kMetric
             ? "valid: this triangulation carries the hyperbolic metric, and all that the proof "
               "says "
               "of it"
             : "valid: the co-volume has a minimiser with these tetrahedra flat, so this "
               "triangulation carries no metric";
}

std::string as_json(const std::string& input, std::string_view kind, bool valid,
                    const std::string& message) {
  JsonText out;
  append_header(out, input);
  append(out, ", \"kind\": ");
  append_string(out, kind);
  append(out, valid ? ", \"valid\": true" : ", \"valid\": false");
  append(out, ", \"message\": ");
  append_string(out, message);
  out.push_back('}');
  return fmt::to_string(out);
}

Reply outcome(const CheckOptions& options, std::string_view kind, bool valid,
              const std::string& message) {
  if (!valid && is_work_over()) throw Stopped();  // which says nothing about the proof
  return {options.json ? as_json(options.input, kind, valid, message) : message + "\n",
          valid ? kSuccess : kNoAnswer};
}

constexpr const char* kOtherLabels =
    "its cone angles are not those of INPUT; label INPUT as in \"FILE 0=3,1=2\"";

bool same_labels(const Subject& subject, std::span<const topology::ConeAngle> cone_angles) {
  return topology::same_angles(subject.cone_angles, cone_angles,
                               subject.triangulation.edge_count());
}

Reply check_one_proof(const CheckOptions& options, const std::string& text) {
  const structure::ProofText proof = parse_file(options.certificate, text, structure::parse_proof);
  const Subject subject = load_labelled_subject(options.input, Balls::kAllowed, interruptible());
  const structure::ProofCheck result =
      same_labels(subject, proof.cone_angles)
          ? structure::check_proof(subject.triangulation, proof, interruptible())
          : structure::ProofCheck{false, kOtherLabels};
  return outcome(options, structure::kind_of(proof), result.valid, proof_verdict(proof, result));
}

Reply check_one_decomposition(const CheckOptions& options, const std::string& text) {
  const auto proof = parse_file(options.certificate, text, structure::parse_canonical_proof);
  const Subject subject = load_labelled_subject(options.input, Balls::kAllowed, interruptible());
  const structure::ProofCheck result = structure::check_canonical_proof(
      subject.triangulation, subject.cone_angles, proof, interruptible());
  return outcome(
      options, structure::kCanonicalDecomposition, result.valid,
      !result ? "not valid: " + result.reason
              : fmt::format("valid: this triangulation carries the hyperbolic metric, and its "
                            "tetrahedra{} are the cells of the canonical decomposition",
                            proof.inside.empty() ? "" : ", merged across the inner faces,"));
}

std::string verdict(const Certificate& certificate, const structure::CheckResult& result) {
  if (!result) return "not valid: " + result.reason;
  if (certificate.kind == Certificate::Kind::kNone) {
    return "valid, kind \"none\": there is no angle structure, so this triangulation carries no "
           "metric";
  }
  return "valid, kind \"semi\": no angle structure is strict, so this triangulation carries no "
         "metric";
}

Reply check_one(const CheckOptions& options) {
  if (options.certificate == "-" && options.input == "-")
    throw InvalidInput("the certificate and INPUT cannot both come from standard input");
  const std::string text = read_file(options.certificate);
  if (structure::looks_like_canonical_proof(text)) return check_one_decomposition(options, text);
  if (structure::looks_like_proof(text)) return check_one_proof(options, text);
  const Certificate certificate =
      parse_file(options.certificate, text, structure::parse_certificate);
  const Subject subject = load_labelled_subject(options.input, Balls::kAllowed, interruptible());
  const structure::CheckResult result = same_labels(subject, certificate.cone_angles)
                                            ? structure::check(subject.triangulation, certificate)
                                            : structure::CheckResult{false, kOtherLabels};
  return outcome(options, to_string(certificate.kind), result.valid, verdict(certificate, result));
}

void add_check(CLI::App* verb, Command& chosen) {
  auto options = std::make_shared<CheckOptions>();
  verb->add_option("CERTIFICATE", options->certificate,
                   "the JSON of a certificate or of a proof, or an answer that has one")
      ->option_text(" ")
      ->required();
  verb->add_option("INPUT", options->input,
                   "the triangulation, labelled as when the certificate was made")
      ->option_text(" ")
      ->transform(unshield())
      ->required();
  verb->add_flag("--json", options->json, "one JSON object on standard output");
  verb->footer(
      "A certificate proves that a triangulation has no strict angle structure, so that it "
      "carries\n"
      "no metric, by integers alone: docs/theory.md (43). A proof (of `prove --json` or "
      "of\n"
      "`canonize --prove --json`) is checked in Arb's ball arithmetic and in a number field, by "
      "code "
      "that\n"
      "shares nothing with the prover: docs/proof.md.\n\n"
      "Exit status: 0 valid, 1 not valid (the message says which inequality fails), 2 bad usage "
      "or\n"
      "bad input, 3 a failure of the program itself.");
  verb->final_callback([options, &chosen] {
    chosen = [options] {
      return answer_inputs(*options, [options](const std::string&) { return check_one(*options); });
    };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> check() {
  static constexpr Verb kRows[] = {
      {"check", "check a certificate or a proof, by other code than made it", add_check, 13}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
