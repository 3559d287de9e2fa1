#include "cli/numbers.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus::cli {
namespace {

/// A check for one option. Without a description it adds nothing to the help, which says it better.
CLI::Validator check(bool (*passes)(std::string_view, int), int largest, std::string expected) {
  return CLI::Validator(
      [passes, largest, expected = std::move(expected)](std::string& text) {
        return passes(text, largest) ? std::string()
                                     : fmt::format("{} is not {}", tripus::quoted(text), expected);
      },
      "");
}

bool is_positive(std::string_view text, int /*largest*/) {
  const auto number = parse_number(text);
  return number && std::isfinite(*number) && *number > 0;
}

bool is_whole(std::string_view text, int largest) {
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= 0 &&
         number <= largest;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

CLI::Validator positive_number() { return check(is_positive, 0, "a finite number greater than 0"); }

CLI::Validator whole_number(int largest) {
  return check(is_whole, largest, fmt::format("a whole number from 0 to {}", largest));
}

}  // namespace tripus::cli
