// tripus check: is this a valid certificate for this triangulation?
#include <memory>

#include <fmt/format.h>

#include "base/error.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "structure/certificate.hpp"

namespace tripus::cli {
namespace {

using structure::Certificate;

struct CheckOptions : CommonOptions {
  std::string certificate;
};

Certificate load_certificate(const std::string& path) {
  const std::string text = read_file(path);
  try {
    return structure::parse_certificate(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput((path == "-" ? "standard input" : quoted(path)) + ": " + error.what());
  }
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

std::string as_json(const std::string& input, const Certificate& certificate,
                    const structure::CheckResult& result) {
  JsonText out;
  append_header(out, input);
  append(out, ", \"kind\": ");
  append_string(out, to_string(certificate.kind));
  append(out, result ? ", \"valid\": true" : ", \"valid\": false");
  append(out, ", \"message\": ");
  append_string(out, verdict(certificate, result));
  out.push_back('}');
  return fmt::to_string(out);
}

Outcome check_one(const CheckOptions& options) {
  if (options.certificate == "-" && options.input == "-")
    throw InvalidInput("the certificate and INPUT cannot both come from standard input");
  const Certificate certificate = load_certificate(options.certificate);
  const topology::Triangulation triangulation(load_input(options.input, interruptible()).gluings);
  const structure::CheckResult result = structure::check(triangulation, certificate);
  return {options.json ? as_json(options.input, certificate, result)
                       : verdict(certificate, result) + "\n",
          result ? kSuccess : kNoAnswer};
}

}  // namespace

void add_check(CLI::App& program, Command& chosen) {
  CLI::App* verb = program.add_subcommand(
      "check", "check a certificate of \"infeasible\" in integer arithmetic");
  auto options = std::make_shared<CheckOptions>();
  verb->add_option("CERTIFICATE", options->certificate,
                   "the JSON of a certificate, or an answer of solve --json that has one")
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
      "no metric: docs/theory.md (43).\n\n"
      "Exit status: 0 valid, 1 not valid (the message says which inequality fails), 2 bad usage "
      "or\n"
      "bad input, 3 a failure of the program itself.");
  verb->final_callback([options, &chosen] {
    chosen = [options] {
      return answer_inputs(*options, [options](const std::string&) { return check_one(*options); });
    };
  });
}

}  // namespace tripus::cli
