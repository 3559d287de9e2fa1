#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "canonical/canonize.hpp"
#include "cli/answer.hpp"
#include "cli/describe.hpp"
#include "cli/verb.hpp"

namespace tripus::cli {

/// Adds what the verbs that look for canonical decompositions have in common.
void add_canonize_options(CLI::App& verb, canonical::CanonizeOptions& options);

/// Has the work end as interrupts and the time limit want it.
void limit_work(canonical::CanonizeOptions& options);

/// The exit status of these verbs, for their help.
extern const char* const kCanonicalStatusHelp;

/// What a verb that canonizes each INPUT by itself was asked for.
struct CanonicalCommand {
  CommonOptions common;
  canonical::CanonizeOptions canonize;
  bool prove = false;
};

/// The option --prove of the verbs that can.
void add_prove_option(CLI::App& verb, bool& prove, const char* what);

}  // namespace tripus::cli
