// tripus canonize: the canonical decomposition, the isometry group and the isometry signature.
#include <array>

#include <fmt/format.h>

#include "canonical/proved.hpp"
#include "cli/canonize_options.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/interrupt.hpp"
#include "cli/manifold_text.hpp"
#include "cli/remedies.hpp"
#include "cli/report_text.hpp"
#include "structure/proof/proof_text.hpp"

namespace tripus::cli {
namespace {

void append_field(JsonText& out, const structure::ExactField& field) {
  append(out, ", \"field\": {\"polynomial\": ");
  append_string(out, field.polynomial);
  append(out, ", \"root\": ");
  append_array(out, std::array{field.root.lower, field.root.upper}, append_string);
  append(out, ", \"gram\": ");
  append_array(out, field.gram, append_string);
  append(out, "}");
}

void append_proof(JsonText& out, const canonical::CanonicalProof& proof) {
  append(out, proof.proved ? ", \"proof\": {\"proved\": true" : ", \"proof\": {\"proved\": false");
  if (!proof.proved) {
    append(out, ", \"reason\": ");
    append_string(out, proof.reason);
  }
  const auto append_face = [](JsonText& to, const auto& face) {
    fmt::format_to(std::back_inserter(to), "[{}, {}]", face.tetrahedron, face.face);
  };
  append(out, ", \"unproved_faces\": ");
  append_array(out, proof.unproved, append_face);
  append(out, ", \"inner_faces\": ");
  append_array(out, proof.inside, append_face);
  if (proof.field) append_field(out, *proof.field);
  append(out, ", \"metric\": " + structure::to_json(structure::proof_text(proof.metric)) + "}");
}

std::string as_json(const Subject& subject, const canonical::CanonizeAnswer& answer,
                    const canonical::CanonicalProof* proof) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append_oriented(out, subject);
  append_cone_orders(out, subject);
  append(out, answer.manifold ? ", \"outcome\": \"geometric\"" : ", \"outcome\": \"unresolved\"");
  if (answer.manifold) {
    append_manifold(out, *answer.manifold);
    append(out, subject.orientation_known ? ", \"orientation_known\": true"
                                          : ", \"orientation_known\": false");
  } else {
    append(out, ", \"certificate\": ");
    append(out,
           answer.report.certificate ? structure::to_json(*answer.report.certificate) : "null");
    append(out, ", \"advice\": ");
    append_string(out, structure::to_string(answer.advice));
  }
  if (proof != nullptr) append_proof(out, *proof);
  append(out, ", \"message\": ");
  append_string(out, answer.message);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Subject& subject, const canonical::CanonizeAnswer& answer,
                    const canonical::CanonicalProof* proof) {
  std::string text = fmt::format("{}: {}\n", printable(subject.input), answer.message);
  if (answer.manifold) {
    text += manifold_as_text(*answer.manifold);
    if (!subject.orientation_known && answer.manifold->decomposition.is_orientable() &&
        !answer.manifold->isometries.is_amphicheiral)
      text +=
          "  the orientation is not known, since the INPUT is a signature without + or -: the "
          "sign\n  above is that of INPUT+\n";
    if (proof != nullptr)
      text += fmt::format("  {:<14}{}\n", "proof", canonical::proof_message(*proof));
    return text;
  }
  if (answer.advice != structure::Advice::kNone)
    text += fmt::format("  {}\n", advice_text(answer.advice));
  text += certificate_as_text(answer.report);
  return text;
}

Outcome canonize_one(const CanonicalCommand& command, const Subject& subject) {
  canonical::CanonizeOptions options = command.canonize;
  options.solve.cone_angles = subject.cone_angles;
  const auto answer = canonical::canonize(subject.triangulation, options);
  std::optional<canonical::CanonicalProof> proof;
  if (command.prove && answer.manifold)
    proof = canonical::prove_canonical(*answer.manifold, interruptible());
  const auto* given = proof ? &*proof : nullptr;
  return {command.common.json ? as_json(subject, answer, given) : as_text(subject, answer, given),
          answer.manifold ? kSuccess : kNoAnswer};
}

}  // namespace

void add_canonize(CLI::App& program, Command& chosen) {
  add_canonical_verb(program, "canonize",
                     "canonical decomposition, isometry group, isometry signature", chosen,
                     canonize_one, true);
}

}  // namespace tripus::cli
