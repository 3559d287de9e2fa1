#include "orthospectrum/detail/window.hpp"

#include <cmath>

#include "base/tolerances.hpp"

namespace tripus::orthospectrum::detail {
namespace {

/// The point of a face over a corner of the window, by weights of the poles: the point
/// sum weight_i w_i has the product -height with the base pole and the square -square.
struct Lifted {
  std::array<double, 3> weight;
  double height, square;
};

/// Products of the poles of a face, with the sign changed: of two different ones, and of each with
/// itself (1, or 0 if ideal; this sign is not changed).
struct Form {
  std::array<double, 3> cosh, square;
};

double polar(const Form& form, const std::array<double, 3>& p, const std::array<double, 3>& q) {
  const auto& [cosh, square] = form;
  return cosh[0] * (p[1] * q[2] + p[2] * q[1]) + cosh[1] * (p[2] * q[0] + p[0] * q[2]) +
         cosh[2] * (p[0] * q[1] + p[1] * q[0]) - square[0] * p[0] * q[0] - square[1] * p[1] * q[1] -
         square[2] * p[2] * q[2];
}

Lifted lift(const std::array<const Vertex*, 3>& face, const Form& form, const Corner& corner) {
  Lifted lifted{};
  for (std::size_t k = 0; k < 3; ++k) {
    lifted.weight[k] = corner.area[k] / face[k]->Z;
    lifted.height -= lifted.weight[k] * face[k]->product;
  }
  lifted.square = polar(form, lifted.weight, lifted.weight);
  return lifted;
}

/// Whether the line between two points of a plane comes within the bound between them, though
/// neither of them does. The largest square / height^2 on it is where the gradients are parallel.
bool meets_between(const Lifted& p, const Lifted& q, const Form& form, double bound) {
  const double mixed = polar(form, p.weight, q.weight);
  const double to_p = q.square * p.height - mixed * q.height;
  const double to_q = p.square * q.height - mixed * p.height;
  if (to_p >= 0 || to_q >= 0) return false;
  const double determinant = mixed * mixed - p.square * q.square;
  return -(p.height * to_p + q.height * to_q) <= bound * determinant;
}

/// The point of the whole plane that is nearest to the base plane, as weights of the poles up to a
/// positive factor; false if the two planes meet.
bool nearest_of_plane(const std::array<const Vertex*, 3>& face, const Form& form,
                      std::array<double, 3>& weight, double& square_of_sinh) {
  // The inverse of the form with c off and -s on the diagonal, times its determinant.
  const auto& [c, s] = form;
  const double determinant = -s[0] * s[1] * s[2] + s[0] * c[0] * c[0] + s[1] * c[1] * c[1] +
                             s[2] * c[2] * c[2] + 2 * c[0] * c[1] * c[2];
  const std::array<double, 3> h{-face[0]->product, -face[1]->product, -face[2]->product};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    weight[i] = (s[j] * s[k] - c[i] * c[i]) * h[i] + (c[i] * c[j] + s[k] * c[k]) * h[j] +
                (c[i] * c[k] + s[j] * c[j]) * h[k];
  }
  const double sum = h[0] * weight[0] + h[1] * weight[1] + h[2] * weight[2];
  square_of_sinh = sum / determinant;
  return sum > 0;
}

}  // namespace

void clip(Window& window, Window& scratch, std::size_t k, const Vertex& through, double dx,
          double dy) {
  bool inside = true;
  for (const Corner& corner : window) inside = inside && corner.area[k] >= 0;
  if (inside) return;
  scratch.clear();
  const double scale = 1 / std::sqrt(dx * dx + dy * dy);
  for (std::size_t n = 0; n < window.size(); ++n) {
    const Corner& here = window[n];
    const Corner& next = window[n + 1 == window.size() ? 0 : n + 1];
    if (here.area[k] >= 0) scratch.push_back(here);
    // Where the boundary leaves, the line takes over; where it comes back, the side goes on.
    const bool leaves = here.area[k] >= 0 && next.area[k] < 0;
    const bool returns = here.area[k] < 0 && next.area[k] > 0;
    if (!leaves && !returns) continue;
    Corner* cut = &scratch.emplace_back(here);
    if (leaves && here.area[k] == 0) {
      scratch.pop_back();
      cut = &scratch.back();
    } else {
      const double share = here.area[k] / (here.area[k] - next.area[k]);
      cut->x = here.x + share * (next.x - here.x);
      cut->y = here.y + share * (next.y - here.y);
      cut->gap = 1 - cut->x * cut->x - cut->y * cut->y;
      for (std::size_t j = 0; j < 3; ++j)
        cut->area[j] = here.area[j] + share * (next.area[j] - here.area[j]);
      cut->area[k] = 0;
    }
    if (leaves) {
      cut->through_x = through.x;
      cut->through_y = through.y;
      cut->normal_x = -dy * scale;
      cut->normal_y = dx * scale;
      cut->base_side = -1;
    }
  }
  window.swap(scratch);
}

Reach::Reach(double length, double shortest)
    : length_(length),
      cosh_(std::cosh(length) * (1 + tolerance::kArcReach)),
      sinh_(std::sinh(length) * (1 + tolerance::kArcReach)),
      up_(std::exp(length)),
      down_(std::exp(-length)),
      cosh_shortest_(std::cosh(shortest)) {}

void Reach::place(Vertex& vertex) const {
  vertex.x = vertex.X / vertex.Z;
  vertex.y = vertex.Y / vertex.Z;
  // For an ideal vertex e^d takes the places of cosh d and sinh d, and its horoball that of l_0.
  const bool is_ideal = vertex.square == 0;
  const double cosh = -vertex.product;
  const double square = is_ideal ? cosh * cosh : (cosh - 1) * (cosh + 1), sinh = std::sqrt(square);
  const double up = cosh + sinh;  // e^d
  const double cosh_difference = is_ideal ? down_ * cosh : (up_ / up + down_ * up) / 2;
  // cosh of the radius, less 1.
  const double excess =
      ((is_ideal ? vertex.level : cosh_shortest_) + cosh_difference) / (sinh * sinh_);
  vertex.room = excess * (2 + excess) * square / (vertex.Z * vertex.Z) * (1 - tolerance::kArcReach);
}

bool Reach::fills(const Vertex& vertex, const Window& window) const {
  for (const Corner& corner : window) {
    const double dx = corner.x - vertex.x, dy = corner.y - vertex.y;
    const double turn = corner.x * dy - corner.y * dx;
    if (dx * dx + dy * dy - turn * turn >= vertex.room * corner.gap) return false;
  }
  return true;
}

bool Reach::meets(const std::array<const Vertex*, 3>& face, const std::array<double, 3>& cosh,
                  const Window& window) const {
  const double bound = sinh_ * sinh_;
  const Form form{cosh, {face[0]->square, face[1]->square, face[2]->square}};
  const auto within = [bound](const Lifted& p) { return p.height * p.height <= bound * p.square; };
  const Lifted first = lift(face, form, window.front());
  if (within(first)) return true;
  Lifted last = first;
  for (std::size_t n = 1; n < window.size(); ++n) {
    const Lifted next = lift(face, form, window[n]);
    if (within(next) || meets_between(last, next, form, bound)) return true;
    last = next;
  }
  if (meets_between(last, first, form, bound)) return true;
  // What is near may still lie wholly within the window.
  std::array<double, 3> weight{};
  double square_of_sinh = 0;
  if (!nearest_of_plane(face, form, weight, square_of_sinh) || square_of_sinh > bound) return false;
  double x = 0, y = 0, z = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    x += weight[k] * face[k]->X;
    y += weight[k] * face[k]->Y;
    z += weight[k] * face[k]->Z;
  }
  if (z <= 0) return false;
  for (const Corner& side : window)
    if (height_over(side, x / z, y / z) < -tolerance::kFootOnLine) return false;
  return true;
}

}  // namespace tripus::orthospectrum::detail
