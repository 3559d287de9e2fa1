// tripus canonize: the canonical decomposition, the isometry group and the isometry signature.
#include <fmt/format.h>

#include "cli/canonize_options.hpp"
#include "cli/commands.hpp"
#include "cli/describe.hpp"
#include "cli/manifold_text.hpp"

namespace tripus::cli {
namespace {

std::string as_json(const Subject& subject, const canonical::CanonizeAnswer& answer) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append(out, answer.manifold ? ", \"outcome\": \"geometric\"" : ", \"outcome\": \"unresolved\"");
  if (answer.manifold) append_manifold(out, *answer.manifold);
  append(out, ", \"message\": ");
  append_string(out, answer.message);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const Subject& subject, const canonical::CanonizeAnswer& answer) {
  std::string text = fmt::format("{}: {}\n", printable(subject.input), answer.message);
  if (answer.manifold) text += manifold_as_text(*answer.manifold);
  return text;
}

Outcome canonize_one(const CanonicalCommand& command, const Subject& subject) {
  const auto answer = canonical::canonize(subject.triangulation, command.canonize);
  return {command.common.json ? as_json(subject, answer) : as_text(subject, answer),
          answer.manifold ? kSuccess : kNoAnswer};
}

}  // namespace

void add_canonize(CLI::App& program, Command& chosen) {
  add_canonical_verb(program, "canonize",
                     "canonical decomposition, isometry group, isometry signature", chosen,
                     canonize_one);
}

}  // namespace tripus::cli
