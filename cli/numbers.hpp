#pragma once

#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>

namespace tripus::cli {

/// The decimal number that the whole text is ("1", "-2.5e-3", "+4", "inf", "nan"), or nothing: also
/// where a double cannot hold it (1e999).
std::optional<double> parse_number(std::string_view text);

/// For an option: a finite number greater than 0.
CLI::Validator positive_number();

/// For an option: a whole number from 0 to `largest`.
CLI::Validator whole_number(int largest);

}  // namespace tripus::cli
