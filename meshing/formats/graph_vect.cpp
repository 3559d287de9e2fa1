#include "meshing/formats/graph_vect.hpp"

#include "meshing/detail/oogl.hpp"
#include "meshing/detail/polylines.hpp"
#include "meshing/detail/scanner.hpp"

namespace tripus::meshing {

SpatialGraph read_vect(std::string_view text) {
  detail::Scanner in("VECT", text, '#');
  detail::skip_oogl_wrapping(in);
  const std::string_view head = in.word();
  if (head != "VECT" && head != "4VECT") in.fail("the file does not begin with VECT");
  const bool homogeneous = head == "4VECT";
  const std::uint32_t count = in.count("the number of polylines", 2);
  const std::uint32_t points = in.count("the number of points", 6);
  in.natural("the number of colours");
  std::vector<detail::Polyline> lines(count);
  std::vector<std::uint32_t> sizes;
  std::uint64_t sum = 0;
  for (detail::Polyline& line : lines) {
    std::string_view word = in.word();
    line.is_closed = word.starts_with('-');
    word.remove_prefix(line.is_closed ? 1 : 0);
    sizes.push_back(in.natural(word, "the number of points of a polyline"));
    sum += sizes.back();
  }
  if (sum != points)
    in.fail("the polylines have " + std::to_string(sum) + " points in all; " +
            std::to_string(points) + " were announced");
  for (std::uint32_t i = 0; i < count; ++i) in.number("a number of colours");
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t k = 0; k < sizes[i]; ++k) {
      Point point = in.point();
      if (homogeneous) {
        const double w = in.number("a coordinate");
        for (double& x : point) x /= w;
      }
      lines[i].points.push_back(point);
    }
  return detail::graph_of(lines);
}

}  // namespace tripus::meshing
