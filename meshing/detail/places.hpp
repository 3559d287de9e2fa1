#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// Names points and cells in messages: "point 3 (line 8)".
class Places {
 public:
  /// `cell` is what cells are called; `lines` must outlive this.
  Places(const SourceLines& lines, std::string_view cell) : lines_(lines), cell_(cell) {}

  std::string point(std::size_t i) const {
    return "point " + numbered(i, lines_.points, lines_.point_numbers);
  }
  std::string cell(std::size_t i) const {
    return std::string(cell_) + " " + numbered(i, lines_.cells, lines_.cell_numbers);
  }
  std::string edge(std::size_t a, std::size_t b) const {
    return "edge " + number(a, lines_.point_numbers) + "-" + number(b, lines_.point_numbers);
  }
  std::string_view cell_name() const { return cell_; }

 private:
  static std::string number(std::size_t i, const std::vector<std::uint32_t>& numbers) {
    return std::to_string(i < numbers.size() ? numbers[i] : i);
  }
  static std::string numbered(std::size_t i, const std::vector<std::uint32_t>& lines,
                              const std::vector<std::uint32_t>& numbers) {
    std::string text = number(i, numbers);
    if (i < lines.size()) text += " (line " + std::to_string(lines[i]) + ")";
    return text;
  }

  const SourceLines& lines_;
  std::string_view cell_;
};

/// "; 3 in all", or nothing for one.
inline std::string in_all(std::size_t count) {
  return count > 1 ? "; " + std::to_string(count) + " such in all" : "";
}

inline std::string edge_name(std::uint32_t a, std::uint32_t b) {
  return std::to_string(a) + "-" + std::to_string(b);
}

/// Throws InvalidInput for a coordinate that is not finite or not in_exact_range.
void require_coordinates(const std::vector<Point>& points, const Places& places);

/// Throws InvalidInput for a point that is marked unused, and for two points that are equal.
void require_points_used(const std::vector<bool>& used, const Places& places);
void require_points_different(const std::vector<Point>& points, const Places& places);

}  // namespace tripus::meshing::detail
