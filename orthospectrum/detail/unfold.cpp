// Seen along the normals of the base plane, a vertex of a tetrahedron is the foot of its common
// perpendicular with the base plane, and a face is an ordinary triangle between three such feet. So
// unfolding the triangulation along a bundle of normal rays is cutting polygons by lines in a disc,
// and an arc of the spectrum is a vertex whose foot lies in the window it is seen through.
#include "orthospectrum/detail/unfold.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/tolerances.hpp"

namespace tripus::orthospectrum::detail {
namespace {

constexpr std::uint64_t kWindowsBetweenPolls = 1024;

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

}  // namespace

Unfolding::Unfolding(const Steps& steps, const Reach& reach, std::span<const Lid> lids)
    : steps_(steps), reach_(reach), lids_(lids) {}

bool Unfolding::search(std::size_t t, int i, const VisitFind& visit, Halt& halt) {
  begin(t, i);
  while (!stack_.empty()) {
    if (++windows_ % kWindowsBetweenPolls == 0 && halt.now()) return false;
    const Node node = stack_.back();
    stack_.pop_back();
    window_.assign(corners_.begin() + static_cast<std::ptrdiff_t>(node.window), corners_.end());
    corners_.resize(node.window);
    expand(node, visit);
  }
  return true;
}

void Unfolding::begin(std::size_t t, int i) {
  base_tetrahedron_ = t;
  base_vertex_ = i;
  stack_.clear();
  corners_.clear();
  const Triangle& triangle = steps_.triangle(t, i);
  Node node;
  node.tetrahedron = static_cast<std::uint32_t>(t);
  node.opposite = static_cast<std::uint8_t>(i);
  node.labels = triangle.corners;
  for (std::size_t k = 0; k < 3; ++k) {
    Vertex& vertex = node.face[k];
    vertex.X = triangle.feet[k][0];
    vertex.Y = triangle.feet[k][1];
    vertex.Z = triangle.feet[k][2];
    vertex.product = triangle.gram[k];
    set_kind(vertex, t, triangle.corners[k]);
    reach_.place(vertex);
  }
  // Nothing symmetric about these shares: no line between feet should pass there.
  constexpr std::array<double, 3> kShares{0.3819660112501052, 0.2763932022500211,
                                          0.3416407864998738};
  inner_x_ = inner_y_ = 0;
  const auto& f = node.face;
  const double area = cross(f[1].x - f[0].x, f[1].y - f[0].y, f[2].x - f[0].x, f[2].y - f[0].y);
  for (std::size_t k = 0; k < 3; ++k) {
    inner_x_ += kShares[k] * f[k].x;
    inner_y_ += kShares[k] * f[k].y;
    const Vertex& next = f[(k + 1) % 3];
    Corner corner;
    corner.x = f[k].x;
    corner.y = f[k].y;
    corner.gap = 1 - corner.x * corner.x - corner.y * corner.y;
    corner.area[k] = area;
    corner.through_x = f[k].x;
    corner.through_y = f[k].y;
    const double length = std::hypot(next.x - f[k].x, next.y - f[k].y);
    corner.normal_x = -(next.y - f[k].y) / length;
    corner.normal_y = (next.x - f[k].x) / length;
    corner.base_side = triangle.corners[(k + 2) % 3];
    corners_.push_back(corner);
  }
  stack_.push_back(node);
}

void Unfolding::set_kind(Vertex& vertex, std::size_t t, int i) const {
  if (!steps_.is_ideal(t, i)) return;
  vertex.square = 0;
  vertex.level = steps_.horoball(t, i);
}

Vertex Unfolding::beyond(const Node& node, const Step& step) const {
  const auto& c = step.combination;
  const double a = c[node.labels[0]], b = c[node.labels[1]], d = c[node.labels[2]],
               e = c[node.opposite];
  const auto& f = node.face;
  const Vertex& o = node.behind;
  Vertex apex;
  apex.X = a * f[0].X + b * f[1].X + d * f[2].X + e * o.X;
  apex.Y = a * f[0].Y + b * f[1].Y + d * f[2].Y + e * o.Y;
  apex.Z = a * f[0].Z + b * f[1].Z + d * f[2].Z + e * o.Z;
  set_kind(apex, step.tetrahedron, step.labels[node.opposite]);
  apex.product = a * f[0].product + b * f[1].product + d * f[2].product + e * o.product;
  reach_.place(apex);
  return apex;
}

void Unfolding::expand(const Node& node, const VisitFind& visit) {
  faces_.resize(node.depth);
  faces_.push_back(node.opposite);
  const Step& step = steps_.step(node.tetrahedron, node.opposite);
  const Vertex apex = beyond(node, step);
  if (apex.square != 0 && -apex.product <= reach_.cosh_length()) look_at(node, step, apex, visit);
  measure(node, apex);
  for (std::size_t k = 0; k < 3; ++k) push_child(node, step, apex, k);
}

/// On which side of the lines from the apex to the vertices of the old face the window's corners
/// lie.
void Unfolding::measure(const Node& node, const Vertex& apex) {
  std::array<double, 3> snap{};
  for (std::size_t k = 0; k < 3; ++k) {
    toward_x_[k] = node.face[k].x - apex.x;
    toward_y_[k] = node.face[k].y - apex.y;
    snap[k] = tolerance::kFootOnLine *
              std::sqrt(toward_x_[k] * toward_x_[k] + toward_y_[k] * toward_y_[k]);
  }
  turns_.resize(window_.size());
  for (std::size_t n = 0; n < window_.size(); ++n) {
    const double x = window_[n].x - apex.x, y = window_[n].y - apex.y;
    for (std::size_t k = 0; k < 3; ++k) {
      const double turn = cross(toward_x_[k], toward_y_[k], x, y);
      turns_[n][k] = std::abs(turn) <= snap[k] ? 0 : turn;
    }
  }
}

/// Whether the foot belongs to this window; with the rule for ties.
bool Unfolding::holds(double x, double y) const {
  for (const Corner& side : window_) {
    double over = height_over(side, x, y);
    if (over < -tolerance::kFootOnLine) return false;
    if (over > tolerance::kFootOnLine) continue;
    if (side.base_side < 0) {
      if (height_over(side, inner_x_, inner_y_) < 0) return false;
      continue;
    }
    const Step& across = steps_.step(base_tetrahedron_, side.base_side);
    const std::tuple here(base_tetrahedron_, base_vertex_, side.base_side);
    const std::tuple there(std::size_t{across.tetrahedron},
                           int{across.labels[static_cast<std::size_t>(base_vertex_)]},
                           int{across.labels[static_cast<std::size_t>(side.base_side)]});
    if (there < here) return false;
  }
  return true;
}

void Unfolding::look_at(const Node& node, const Step& step, const Vertex& apex,
                        const VisitFind& visit) {
  if (!holds(apex.x, apex.y)) return;
  Find find;
  find.length = std::acosh(-apex.product);
  if (find.length > reach_.length()) return;
  find.x = apex.x;
  find.y = apex.y;
  find.tetrahedron = step.tetrahedron;
  find.vertex = step.labels[node.opposite];
  for (std::size_t k = 0; k < 3; ++k)
    find.products[step.labels[node.labels[k]]] = node.face[k].product;
  find.products[step.labels[node.opposite]] = apex.product;
  find.faces = faces_;
  visit(find);
}

/// The face with vertices k and k + 1 of the old one and the new vertex.
void Unfolding::push_child(const Node& node, const Step& step, const Vertex& apex, std::size_t k) {
  const std::size_t m = (k + 1) % 3;
  const Vertex& a = node.face[k];
  const Vertex& b = node.face[m];
  const double ax = toward_x_[k], ay = toward_y_[k], bx = toward_x_[m], by = toward_y_[m];
  if (cross(ax, ay, bx, by) <= 0) return;  // this face lies behind
  bool left = false, right = false;
  for (const auto& turn : turns_) {
    left = left || turn[k] > 0;
    right = right || turn[m] < 0;
  }
  if (!left || !right) return;
  child_.clear();
  for (std::size_t n = 0; n < window_.size(); ++n) {
    Corner& copy = child_.emplace_back(window_[n]);
    copy.area = {-turns_[n][m], turns_[n][k], window_[n].area[(k + 2) % 3]};
  }
  clip(child_, scratch_, 1, apex, ax, ay);
  clip(child_, scratch_, 0, apex, -bx, -by);
  left = right = false;
  for (const Corner& corner : child_) {
    left = left || corner.area[1] > 0;
    right = right || corner.area[0] > 0;
  }
  if (!left || !right) return;
  if (reach_.fills(a, child_) || reach_.fills(b, child_) || reach_.fills(apex, child_)) return;
  const std::uint8_t label_a = step.labels[node.labels[k]];
  const std::uint8_t label_b = step.labels[node.labels[(k + 1) % 3]];
  const std::uint8_t label_apex = step.labels[node.opposite];
  const std::size_t t = step.tetrahedron;
  Node& next = stack_.emplace_back();
  next.face = {a, b, apex};
  next.behind = node.face[(k + 2) % 3];
  next.labels = {label_a, label_b, label_apex};
  next.opposite = step.labels[node.labels[(k + 2) % 3]];
  next.tetrahedron = step.tetrahedron;
  next.depth = node.depth + 1;
  next.window = corners_.size();
  if (is_lidded(next) || !reach_.meets({&a, &b, &apex},
                                       {steps_.cosh_length(t, label_b, label_apex),
                                        steps_.cosh_length(t, label_apex, label_a),
                                        steps_.cosh_length(t, label_a, label_b)},
                                       child_)) {
    stack_.pop_back();
    return;
  }
  corners_.insert(corners_.end(), child_.begin(), child_.end());
}

/// Whether the discs around the feet of the face's vertices leave no room within the face.
bool Unfolding::is_lidded(const Node& next) const {
  const Lid& lid = lids_[4 * std::size_t{next.tetrahedron} + next.opposite];
  if (!lid.exists) return false;
  const auto& c = lid.combination;
  const double p = c[next.labels[0]], q = c[next.labels[1]], r = c[next.labels[2]],
               s = c[next.opposite];
  const auto& f = next.face;
  const Vertex& o = next.behind;
  const double cosh = -(p * f[0].product + q * f[1].product + r * f[2].product + s * o.product);
  if (cosh <= reach_.cosh_length()) return false;
  const double Z = p * f[0].Z + q * f[1].Z + r * f[2].Z + s * o.Z;
  const double x = (p * f[0].X + q * f[1].X + r * f[2].X + s * o.X) / Z;
  const double y = (p * f[0].Y + q * f[1].Y + r * f[2].Y + s * o.Y) / Z;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& a = f[k];
    const Vertex& b = f[(k + 1) % 3];
    if (cross(b.x - a.x, b.y - a.y, x - a.x, y - a.y) < 0) return false;
  }
  return true;
}

}  // namespace tripus::orthospectrum::detail
