#pragma once

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

/// The record of an INPUT that was refused: its name, and "refused" for the outcome.
std::string refused_record(const std::vector<const RecordField*>& fields, const std::string& input);

/// Names and meanings for a help text.
std::string fields_help();

}  // namespace tripus::cli
