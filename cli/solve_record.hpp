#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "cli/metric.hpp"

namespace tripus::cli {

/// One column of the short record of an answer of `solve`.
struct RecordField {
  std::string_view name;
  std::string_view meaning;
  /// Empty where there is nothing to say: of metrics where none was found.
  std::string (*text)(const Solved& solved);
};

/// The fields of a list such as "input,outcome,volume". Throws InvalidInput, naming what is no
/// field, and for one that comes twice.
std::vector<const RecordField*> parse_fields(std::string_view list);

/// The names, separated by tabs, with a line end.
std::string record_header(const std::vector<const RecordField*>& fields);

/// The answer, separated by tabs, with a line end.
std::string record(const std::vector<const RecordField*>& fields, const Solved& solved);

/// The record of an INPUT whose answer has failed: its name, and for the outcome "refused", or
/// "unresolved" where the INPUT was not the reason (time, memory, the system).
std::string failed_record(const std::vector<const RecordField*>& fields, const std::string& input,
                          const std::exception& error);

/// Names and meanings for a help text.
std::string fields_help();

}  // namespace tripus::cli
