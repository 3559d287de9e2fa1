#include "meshing/detail/places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing::detail {

void require_coordinates(const std::vector<Point>& points, const Places& places) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = points[i][k];
      const std::string what = places.point(i) + " has " + "xyz"[k] + " = " + number_text(x);
      if (!std::isfinite(x)) throw InvalidInput(what + "; coordinates must be finite numbers");
      if (!in_exact_range(x))
        throw InvalidInput(what +
                           "; coordinates must be 0 or between 1e-70 and 1e70 in size: scale the "
                           "mesh");
    }
}

void require_points_used(const std::vector<bool>& used, const Places& places) {
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  if (count == 0) return;
  const auto first =
      static_cast<std::size_t>(std::find(used.begin(), used.end(), false) - used.begin());
  throw InvalidInput(places.point(first) + " belongs to no " + std::string(places.cell_name()) +
                     in_all(count) + "; remove unused points");
}

void require_points_different(const std::vector<Point>& points, const Places& places) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  std::size_t count = 0;
  std::uint32_t first = 0, second = UINT32_MAX;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (points[order[i - 1]] != points[order[i]]) continue;
    ++count;
    if (order[i] < second) first = order[i - 1], second = order[i];
  }
  if (count > 0)
    throw InvalidInput(places.point(first) + " and " + places.point(second) + " are equal" +
                       in_all(count) + "; merge equal points into one");
}

}  // namespace tripus::meshing::detail
