#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/binary.hpp"
#include "base/detail/guarded_json.hpp"
#include "base/error.hpp"
#include "cli/files.hpp"
#include "cli/numbers.hpp"

namespace tripus::cli {
namespace {

constexpr std::string_view kWhite = " \t\r\n\v\f";

std::vector<double> from_json(std::string_view text) {
  const auto document =
      detail::parse_guarded_json(text, "numbers, or an answer of `tripus solve --json`");
  const nlohmann::json* list = &document;
  if (document.is_object()) {
    const auto found = document.find("edge_lengths");
    if (found == document.end()) throw InvalidInput("the JSON object has no \"edge_lengths\"");
    list = &*found;
  }
  if (!list->is_array()) throw InvalidInput("\"edge_lengths\" is not an array of numbers");
  std::vector<double> lengths;
  for (const auto& entry : *list) {
    if (!entry.is_number())
      throw InvalidInput(fmt::format("edge length {} is not a number", lengths.size()));
    lengths.push_back(entry.get<double>());
  }
  return lengths;
}

}  // namespace

std::vector<double> parse_lengths(std::string_view text) {
  if (is_binary(text)) throw InvalidInput("it is a binary file and holds no lengths");
  const std::size_t first = text.find_first_not_of(kWhite);
  if (first != std::string_view::npos && (text[first] == '{' || text[first] == '['))
    return from_json(text);
  std::vector<double> lengths;
  std::size_t line_number = 0;
  while (!text.empty()) {
    ++line_number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, std::min(end, text.find('#')));
    text.remove_prefix(std::min(end + 1, text.size()));
    constexpr std::string_view kSeparators = " \t\r\v\f,;";
    for (std::size_t at = line.find_first_not_of(kSeparators); at != std::string_view::npos;
         at = line.find_first_not_of(kSeparators)) {
      line.remove_prefix(at);
      const std::string_view token = line.substr(0, line.find_first_of(kSeparators));
      const auto value = parse_number(token);
      if (!value) {
        throw InvalidInput(
            fmt::format("line {}: {} is not a number", line_number, quoted(std::string(token))));
      }
      lengths.push_back(*value);
      line.remove_prefix(token.size());
    }
  }
  return lengths;
}

double parse_angle(std::string_view text) {
  const std::string whole(text);
  double value = 1;
  const std::size_t pi = text.find("pi");
  if (pi == std::string_view::npos) {
    const auto number = parse_number(text);
    if (number && std::isfinite(*number)) return *number;
    throw InvalidInput(quoted(whole) + " is not an angle; write radians, such as 6.28 or 2pi/3");
  }
  std::optional<double> factor = pi == 0 ? 1.0 : parse_number(text.substr(0, pi));
  const std::string_view rest = text.substr(pi + 2);
  std::optional<double> divisor = 1.0;
  if (!rest.empty()) divisor = rest.front() == '/' ? parse_number(rest.substr(1)) : std::nullopt;
  if (factor && divisor) value = *factor * std::numbers::pi / *divisor;
  if (!factor || !divisor || !std::isfinite(value))
    throw InvalidInput(quoted(whole) + " is not an angle; write radians, such as 6.28 or 2pi/3");
  return value;
}

}  // namespace tripus::cli
