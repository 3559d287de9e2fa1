#include "structure/proof/detail/proof_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace tripus::structure::detail {

using nlohmann::json;

std::string interval_json(const DecimalInterval& interval) {
  return fmt::format("[\"{}\", \"{}\"]", interval.lower, interval.upper);
}

void refuse(const std::string& place, std::string_view expected) {
  throw InvalidInput(fmt::format("proof: {}: expected {}", place, expected));
}

const json& member(const json& object, const char* name, std::string_view expected) {
  const auto found = object.find(name);
  if (found == object.end()) refuse(fmt::format("\"{}\" is missing", name), expected);
  return *found;
}

std::vector<std::string> read_texts(const json& object, const char* name, std::string_view shape) {
  const json& list = member(object, name, shape);
  if (!list.is_array()) refuse(fmt::format("\"{}\"", name), shape);
  std::vector<std::string> texts;
  for (const json& item : list) {
    if (!item.is_string()) refuse(fmt::format("\"{}\" {}", name, texts.size()), "a text");
    texts.push_back(item.get<std::string>());
  }
  return texts;
}

DecimalInterval read_interval(const json& value, const std::string& place) {
  if (!value.is_array() || value.size() != 2 || !value[0].is_string() || !value[1].is_string())
    refuse(place, "an array of two texts, lower and upper bound");
  return {value[0].get<std::string>(), value[1].get<std::string>()};
}

std::vector<std::size_t> read_numbers(const json& value, const std::string& place) {
  constexpr std::string_view kShape = "an array of numbers";
  if (!value.is_array()) refuse(place, kShape);
  std::vector<std::size_t> numbers;
  for (const json& item : value) {
    if (!item.is_number_unsigned()) refuse(place, kShape);
    numbers.push_back(item.get<std::size_t>());
  }
  return numbers;
}

}  // namespace tripus::structure::detail
