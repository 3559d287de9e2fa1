#include "cli/canonize_options.hpp"

#include <limits>

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"

namespace tripus::cli {

void add_canonize_options(CLI::App& verb, canonical::CanonizeOptions& options) {
  verb.add_option("--budget", options.retriangulation.budget,
                  fmt::format("triangulations to try where one carries no metric (default: {})",
                              options.retriangulation.budget))
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
}

void limit_work(canonical::CanonizeOptions& options) {
  options.solve.stop = &stop_flag();
  options.solve.time_limit = seconds_left();
}

void add_prove_option(CLI::App& verb, bool& prove, const char* what) {
  verb.add_flag("--prove", prove, what)->option_text(" ");
}

const char* const kCanonicalStatusHelp =
    "Exit status: 0 an answer (for --batch: the run finished), 1 \"no\", unresolved or "
    "interrupted,\n"
    "2 bad usage or bad input, 3 a failure of the program itself.";

}  // namespace tripus::cli
