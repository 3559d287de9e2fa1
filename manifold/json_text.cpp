#include "manifold/json_text.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/stop.hpp"
#include "base/version.hpp"

namespace tripus {

void append_string(JsonText& out, std::string_view text) {
  const nlohmann::json value(text);
  append(out, value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void append_number(JsonText& out, double value) {
  if (!std::isfinite(value)) throw InternalError("a number to be printed is not finite");
  fmt::format_to(std::back_inserter(out), "{}", value);
}

void append_numbers(JsonText& out, std::span<const double> values) {
  append_array(out, values, append_number);
}

void append_text_key(JsonText& out, std::string_view key, std::string_view value) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": ", key);
  append_string(out, value);
}

void append_number_key(JsonText& out, std::string_view key, double value) {
  fmt::format_to(std::back_inserter(out), ", \"{}\": ", key);
  append_number(out, value);
}

void append_header(JsonText& out, std::string_view input) {
  append(out, "{\"tripus\": ");
  append_string(out, kVersion);
  append(out, ", \"input\": ");
  append_string(out, input);
}

std::string_view error_kind(const std::exception& error) {
  if (dynamic_cast<const Unsupported*>(&error) != nullptr) return "unsupported";
  if (dynamic_cast<const InvalidInput*>(&error) != nullptr) return "invalid-input";
  if (dynamic_cast<const Stopped*>(&error) != nullptr) return "interrupted";
  if (dynamic_cast<const IoError*>(&error) != nullptr) return "system";
  return "internal";
}

void append_error(JsonText& out, std::string_view input, std::string_view kind,
                  std::string_view message) {
  append_header(out, input);
  append(out, ", \"error\": {\"kind\": ");
  append_string(out, kind);
  append(out, ", \"message\": ");
  append_string(out, message);
  append(out, "}}");
}

}  // namespace tripus
