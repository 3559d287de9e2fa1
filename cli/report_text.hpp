#pragma once

#include <string>

#include "cli/describe.hpp"
#include "structure/report.hpp"

namespace tripus::cli {

/// The JSON of `tripus solve`, with its keys in the documented order; no line end.
std::string report_as_json(const Subject& subject, const structure::Report& report);

/// The same for people, over several lines.
std::string report_as_text(const Subject& subject, const structure::Report& report);

}  // namespace tripus::cli
