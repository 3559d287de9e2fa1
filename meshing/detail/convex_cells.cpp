#include "meshing/detail/convex_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "meshing/detail/connectivity.hpp"

namespace tripus::meshing::detail {
namespace {

/// Of a sum of four products of numbers that are each off by 2^-53 of themselves, or truncated.
constexpr double kSumRounding = 0x1p-48;

std::array<Rational, 3> rational(const Point& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}

}  // namespace

RationalPoint::RationalPoint(std::array<Rational, 3> coordinates) : exact(std::move(coordinates)) {
  for (std::size_t k = 0; k < 3; ++k) near[k] = exact[k].get_d();
}

RationalPoint::RationalPoint(const Point& p) : exact(rational(p)), near(p) {}

RationalPlane::RationalPlane(const Point& a, const Point& b, const Point& c) {
  const auto o = rational(a), p = rational(b), q = rational(c);
  std::array<Rational, 3> u, v;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = p[k] - o[k];
    v[k] = q[k] - o[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    exact[k] = u[i] * v[j] - u[j] * v[i];
    exact[3] -= exact[k] * o[k];
  }
  // One form for each plane and direction.
  Rational size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max<Rational>(size, abs(exact[k]));
  for (std::size_t k = 0; k < 4; ++k) {
    exact[k] /= size;
    near[k] = exact[k].get_d();
  }
}

int RationalPlane::side(const RationalPoint& p) const {
  double sum = near[3], size = std::fabs(near[3]);
  for (std::size_t k = 0; k < 3; ++k) {
    sum += near[k] * p.near[k];
    size += std::fabs(near[k] * p.near[k]);
  }
  if (std::fabs(sum) > kSumRounding * size) return sum > 0 ? 1 : -1;
  Rational value = exact[3];
  for (std::size_t k = 0; k < 3; ++k) value += exact[k] * p.exact[k];
  return sgn(value);
}

RationalPoint crossing(const RationalPlane& plane, const RationalPoint& p, const RationalPoint& q) {
  Rational at_p = plane.exact[3], at_q = plane.exact[3];
  for (std::size_t k = 0; k < 3; ++k) {
    at_p += plane.exact[k] * p.exact[k];
    at_q += plane.exact[k] * q.exact[k];
  }
  const Rational t = at_p / (at_p - at_q);
  std::array<Rational, 3> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = p.exact[k] + t * (q.exact[k] - p.exact[k]);
  return RationalPoint(std::move(result));
}

ConvexCells::ConvexCells(const Point& low, const Point& high) {
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (corner >> k & 1u) != 0 ? high[k] : low[k];
    points_.emplace_back(p);
  }
  cells_.emplace_back();
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
    for (const std::uint32_t base : {0u, 1u << axis})
      cells_[0].faces.push_back(
          add_face({{base, base + u, base + u + v, base + v}, {0, kNone}, kNone}));
  }
}

std::uint32_t ConvexCells::add_face(Face face) {
  const auto number = static_cast<std::uint32_t>(faces_.size());
  for (std::size_t i = 0; i < face.loop.size(); ++i)
    faces_at_[pair_key(face.loop[i], face.loop[(i + 1) % face.loop.size()])].push_back(number);
  faces_.push_back(std::move(face));
  return number;
}

void ConvexCells::split_edge(std::uint32_t a, std::uint32_t b, const RationalPlane& plane) {
  const auto middle = static_cast<std::uint32_t>(points_.size());
  points_.push_back(crossing(plane, points_[a], points_[b]));
  sides_.push_back(0);
  auto node = faces_at_.extract(pair_key(a, b));
  for (const std::uint32_t f : node.mapped()) {
    auto& loop = faces_[f].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = (i + 1) % loop.size();
      if (pair_key(loop[i], loop[next]) != pair_key(a, b)) continue;
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
      break;
    }
  }
  faces_at_[pair_key(a, middle)] = node.mapped();
  faces_at_[pair_key(middle, b)] = std::move(node.mapped());
}

void ConvexCells::split_face(std::uint32_t face) {
  // From its first corner on the plane, the loop is turned so that the positive part comes first.
  std::vector<std::uint32_t> loop = faces_[face].loop;
  const auto starts_positive = [&](std::size_t i) {
    return sides_[loop[i]] == 0 && sides_[loop[(i + 1) % loop.size()]] > 0;
  };
  std::size_t start = 0;
  while (start < loop.size() && !starts_positive(start)) ++start;
  if (start == loop.size()) throw InternalError("a face that a plane cuts has no corner on it");
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
  std::size_t end = 1;
  while (sides_[loop[end]] > 0) ++end;
  const std::uint32_t from = loop[0], to = loop[end];
  Face positive = faces_[face];
  positive.loop.assign(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  std::vector<std::uint32_t> negative(loop.begin() + static_cast<std::ptrdiff_t>(end), loop.end());
  negative.push_back(from);
  for (std::size_t i = 0; i < end; ++i) std::erase(faces_at_[pair_key(loop[i], loop[i + 1])], face);
  faces_[face].loop = std::move(negative);
  faces_at_[pair_key(from, to)].push_back(face);
  const std::array<std::uint32_t, 2> cells = positive.cells;
  const std::uint32_t fresh = add_face(std::move(positive));
  for (const std::uint32_t c : cells)
    if (c != kNone) cells_[c].faces.push_back(fresh);
}

std::vector<std::uint32_t> ConvexCells::zero_loop(const Cell& cell) const {
  std::map<std::uint32_t, std::vector<std::uint32_t>> beside;
  for (const std::uint32_t f : cell.faces) {
    const auto& loop = faces_[f].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (sides_[a] != 0 || sides_[b] != 0) continue;
      for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
        auto& others = beside[from];
        if (std::find(others.begin(), others.end(), to) == others.end()) others.push_back(to);
      }
    }
  }
  std::vector<std::uint32_t> loop;
  std::uint32_t previous = kNone, here = beside.begin()->first;
  do {
    loop.push_back(here);
    const auto& others = beside.at(here);
    if (others.size() != 2) throw InternalError("a plane does not cut a convex cell in a polygon");
    const std::uint32_t next = others[0] == previous ? others[1] : others[0];
    previous = std::exchange(here, next);
  } while (here != loop.front() && loop.size() <= beside.size());
  if (loop.size() != beside.size())
    throw InternalError("a plane does not cut a convex cell in one polygon");
  return loop;
}

std::vector<std::uint32_t> ConvexCells::corners(std::uint32_t cell) const {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t f : cells_[cell].faces)
    result.insert(result.end(), faces_[f].loop.begin(), faces_[f].loop.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::uint32_t ConvexCells::cut(std::uint32_t cell, const RationalPlane& plane, std::uint32_t name) {
  sides_.resize(points_.size());
  for (const std::uint32_t v : corners(cell)) sides_[v] = plane.side(points_[v]);
  const std::vector<std::uint32_t> faces = cells_[cell].faces;
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const std::uint32_t f : faces) {
    const auto& loop = faces_[f].loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (sides_[a] * sides_[b] < 0) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) split_edge(a, b, plane);
  const auto has = [&](std::uint32_t f, int sign) {
    const auto& loop = faces_[f].loop;
    return std::any_of(loop.begin(), loop.end(),
                       [&](std::uint32_t v) { return sides_[v] == sign; });
  };
  for (const std::uint32_t f : faces)
    if (has(f, 1) && has(f, -1)) split_face(f);
  const auto fresh = static_cast<std::uint32_t>(cells_.size());
  Face between{zero_loop(cells_[cell]), {cell, fresh}, name};
  cells_.emplace_back();
  std::vector<std::uint32_t> all = std::move(cells_[cell].faces);
  cells_[cell].faces.clear();
  for (const std::uint32_t f : all) {
    const bool positive = has(f, 1);
    cells_[positive ? fresh : cell].faces.push_back(f);
    if (positive)
      for (std::uint32_t& c : faces_[f].cells)
        if (c == cell) c = fresh;
  }
  const std::uint32_t face = add_face(std::move(between));
  cells_[cell].faces.push_back(face);
  cells_[fresh].faces.push_back(face);
  return fresh;
}

}  // namespace tripus::meshing::detail
