#include "manifold/labels.hpp"

#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus {
namespace {

/// One "EDGE=VALUE": the edge and the text of the value.
std::pair<std::size_t, std::string_view> split_assignment(std::string_view text,
                                                          std::string_view example,
                                                          std::size_t edge_count) {
  const std::size_t equals = text.find('=');
  const std::string_view number = text.substr(0, equals);
  std::size_t edge = 0;
  const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), edge);
  if (equals == std::string_view::npos || code != std::errc() ||
      end != number.data() + number.size())
    throw InvalidInput(fmt::format("write {}", example));
  if (edge >= edge_count)
    throw InvalidInput(fmt::format("there are only the edge classes 0 to {}", edge_count - 1));
  return {edge, text.substr(equals + 1)};
}

}  // namespace

void LabelAssignment::assign(std::string_view place, std::string_view list,
                             std::string_view example,
                             const std::function<topology::ConeAngle(std::string_view)>& parse) {
  if (cone_angles_.empty()) cone_angles_.resize(edge_count_);
  for (bool last = false; !last;) {
    const std::size_t comma = list.find(',');
    const std::string_view text = list.substr(0, comma);
    last = comma == std::string_view::npos;
    if (!last) list.remove_prefix(comma + 1);
    try {
      const auto [edge, value] = split_assignment(text, example, edge_count_);
      if (assigned_[edge])
        throw InvalidInput(
            fmt::format("edge class {} has a label already; give one for each edge class", edge));
      assigned_[edge] = true;
      cone_angles_[edge] = parse(value);
    } catch (const InvalidInput& error) {
      throw InvalidInput(fmt::format("{} {}: {}", place, quoted(std::string(text)), error.what()));
    }
  }
}

std::vector<topology::ConeAngle> labelled(std::vector<topology::ConeAngle> cone_angles,
                                          std::size_t edge_count, const std::string& labels) {
  if (!labels.empty())
    LabelAssignment(cone_angles, edge_count)
        .assign("the label", labels, "EDGE=ORDER, such as 0=3", topology::parse_cone_order);
  return cone_angles;
}

std::pair<std::string, std::string> split_labels(const std::string& input) {
  const std::size_t space = input.find_last_of(" \t");
  if (space == std::string::npos || input.find('=', space) == std::string::npos) return {input, {}};
  const std::string labels = input.substr(space + 1);
  if (labels.find_first_not_of("0123456789=,./-") != std::string::npos) return {input, {}};
  std::error_code status;
  if (std::filesystem::exists(input, status)) return {input, {}};
  const std::size_t end = input.find_last_not_of(" \t", space);
  return {input.substr(0, end == std::string::npos ? 0 : end + 1), labels};
}

}  // namespace tripus
