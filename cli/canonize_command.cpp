// tripus canonize: the canonical decomposition, the isometry group and the isometry signature.
#include <fmt/format.h>

#include "cli/canonize_options.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/manifold_text.hpp"
#include "cli/remedies.hpp"
#include "cli/report_text.hpp"

namespace tripus::cli {
namespace {

std::string as_json(const Subject& subject, const canonical::CanonizeAnswer& answer) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append_oriented(out, subject);
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
  append(out, ", \"message\": ");
  append_string(out, answer.message);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Subject& subject, const canonical::CanonizeAnswer& answer) {
  std::string text = fmt::format("{}: {}\n", printable(subject.input), answer.message);
  if (answer.manifold) {
    text += manifold_as_text(*answer.manifold);
    if (!subject.orientation_known && answer.manifold->decomposition.is_orientable() &&
        !answer.manifold->isometries.is_amphicheiral)
      text += "  the orientation is not known, since the INPUT is a signature without + or -: the "
              "sign\n  above is that of INPUT+\n";
    return text;
  }
  if (answer.advice != structure::Advice::kNone)
    text += fmt::format("  {}\n", advice_text(answer.advice));
  text += certificate_as_text(answer.report);
  return text;
}

Outcome canonize_one(const CanonicalCommand& command, const Subject& subject) {
  const auto answer = canonical::canonize(subject.triangulation, command.canonize);
  return {command.common.json ? as_json(subject, answer) : as_text(subject, answer),
          answer.manifold ? kSuccess : kNoAnswer, subject.notes};
}

}  // namespace

void add_canonize(CLI::App& program, Command& chosen) {
  add_canonical_verb(program, "canonize",
                     "canonical decomposition, isometry group, isometry signature", chosen,
                     canonize_one);
}

}  // namespace tripus::cli
