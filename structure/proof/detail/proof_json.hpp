#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "structure/proof/digits.hpp"

/// Pieces of the JSON of proofs.
namespace tripus::structure::detail {

std::string interval_json(const DecimalInterval& interval);

template <class Items, class ToText>
std::string list_json(const Items& items, ToText to_text) {
  std::string text = "[";
  for (const auto& item : items) {
    if (text.size() > 1) text += ", ";
    text += to_text(item);
  }
  return text + "]";
}

/// Throws InvalidInput: "proof: PLACE: expected ...". So do all of these.
[[noreturn]] void refuse(const std::string& place, std::string_view expected);

const nlohmann::json& member(const nlohmann::json& object, const char* name,
                             std::string_view expected);
std::vector<std::string> read_texts(const nlohmann::json& object, const char* name,
                                    std::string_view shape);
DecimalInterval read_interval(const nlohmann::json& value, const std::string& place);
/// Whole numbers >= 0.
std::vector<std::size_t> read_numbers(const nlohmann::json& value, const std::string& place);

}  // namespace tripus::structure::detail
