// Cone angles as they are typed: --cone-order, --cone-angle, and behind an INPUT in a batch.
#include "cli/labels.hpp"

#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.hpp"
#include "cli/describe.hpp"
#include "cli/lengths_file.hpp"

namespace tripus::cli {
namespace {

/// One "EDGE=VALUE", and where it was typed.
struct Assignment {
  std::string option;
  std::string_view text;
  std::size_t edge = 0;
  std::string_view value = {};

  [[noreturn]] void refuse(const std::string& why) const {
    throw InvalidInput(fmt::format("{} {}: {}", option, quoted(std::string(text)), why));
  }
};

Assignment parse_assignment(const std::string& option, std::string_view text,
                            std::string_view example, std::size_t edge_count) {
  Assignment result{option, text};
  const std::size_t equals = text.find('=');
  const std::string_view number = text.substr(0, equals);
  const auto [end, code] =
      std::from_chars(number.data(), number.data() + number.size(), result.edge);
  if (equals == std::string_view::npos || code != std::errc() ||
      end != number.data() + number.size())
    result.refuse(fmt::format("write {}", example));
  if (result.edge >= edge_count)
    result.refuse(fmt::format("there are only the edge classes 0 to {}", edge_count - 1));
  result.value = text.substr(equals + 1);
  return result;
}

/// Calls visit for each part between commas.
template <class Visit>
void for_each_part(std::string_view list, const Visit& visit) {
  for (;;) {
    const std::size_t comma = list.find(',');
    visit(list.substr(0, comma));
    if (comma == std::string_view::npos) return;
    list.remove_prefix(comma + 1);
  }
}

topology::ConeAngle angle_of(const Assignment& assignment, bool is_order) {
  try {
    if (is_order) return topology::parse_cone_order(assignment.value);
    const double angle = parse_angle(assignment.value);
    if (angle < 0) assignment.refuse("a cone angle is not negative; 0 makes the edge parabolic");
    return angle;
  } catch (const InvalidInput& error) {
    if (std::string_view(error.what()).starts_with("--cone-")) throw;
    assignment.refuse(error.what());
  }
}

}  // namespace

void assign_cone_angles(std::vector<topology::ConeAngle>& cone_angles, std::size_t edge_count,
                        std::span<const std::string> orders, std::span<const std::string> angles) {
  if (orders.empty() && angles.empty()) return;
  if (cone_angles.empty()) cone_angles.resize(edge_count);
  std::vector<bool> assigned(edge_count);
  const auto assign = [&](std::string_view text, bool is_order) {
    const Assignment assignment = parse_assignment(
        is_order ? "--cone-order" : "--cone-angle", text,
        is_order ? "EDGE=ORDER, such as 0=3" : "EDGE=ANGLE, such as 0=2pi/3", edge_count);
    if (assigned[assignment.edge])
      assignment.refuse(fmt::format(
          "edge class {} has a label already; give one for each edge class", assignment.edge));
    assigned[assignment.edge] = true;
    cone_angles[assignment.edge] = angle_of(assignment, is_order);
  };
  for (const std::string& list : orders)
    for_each_part(list, [&](std::string_view text) { assign(text, true); });
  for (const std::string& list : angles)
    for_each_part(list, [&](std::string_view text) { assign(text, false); });
}

std::pair<std::string, std::string> split_labels(const std::string& input) {
  const std::size_t space = input.find_last_of(" \t");
  const std::size_t equals = input.find('=', space == std::string::npos ? 0 : space);
  if (space == std::string::npos || equals == std::string::npos) return {input, {}};
  const std::string labels = input.substr(space + 1);
  if (labels.find_first_not_of("0123456789=,./") != std::string::npos) return {input, {}};
  std::error_code status;
  if (std::filesystem::exists(input, status)) return {input, {}};
  const std::size_t end = input.find_last_not_of(" \t", space);
  return {input.substr(0, end == std::string::npos ? 0 : end + 1), labels};
}

}  // namespace tripus::cli
