#pragma once

#include <array>
#include <cstddef>
#include <vector>

/// Windows: the convex polygons, on the plane where a bundle of normal rays begins, through which
/// it leaves a tetrahedron by a face.
namespace tripus::orthospectrum::detail {

/// A vertex of the tetrahedron that the bundle leaves, as seen from the base plane with pole v:
/// the pole w of its truncation has the projection (X, Y, Z) to the base plane and the product
/// <v, w> = -cosh d. So (x, y) = (X, Y) / Z is the foot of the common perpendicular of both planes.
/// Of an ideal vertex w is the point itself: (x, y) is the foot of the ray into the cusp.
struct Vertex {
  double X = 0, Y = 0, Z = 0;
  double product = 1;
  double square = 1;  ///< <w, w>: 1, or 0 if ideal
  double level = 0;   ///< if ideal, of its horoball; see Steps::horoball
  double x = 0, y = 0;
  /// No arc that is short enough has its foot nearer to (x, y) than this allows; see `Reach`.
  double room = 0;
};

/// A corner of a window, in the projective model of the base plane, and the side from it to the
/// next corner, which has the window to its left.
struct Corner {
  double x = 0, y = 0;
  double gap = 0;  ///< 1 - x^2 - y^2
  /// Twice the areas of the triangles that the point makes with the sides of the face opposite to
  /// its vertices a, b, c: all >= 0 within the face.
  std::array<double, 3> area{};
  double through_x = 0, through_y = 0, normal_x = 0, normal_y = 0;  ///< the line of the side
  int base_side = -1;  ///< the face that this side of the base triangle lies in; -1: within it
};
using Window = std::vector<Corner>;

/// How far beyond a line a point lies, > 0 on the side of the window.
inline double height_over(const Corner& side, double x, double y) {
  return (x - side.through_x) * side.normal_x + (y - side.through_y) * side.normal_y;
}

/// Cuts off what has area[k] < 0. `through` and (dx, dy): a point of the line where area[k] = 0,
/// and its direction with the window to the left.
void clip(Window& window, Window& scratch, std::size_t k, const Vertex& through, double dx,
          double dy);

/// What a length bound L leaves of the bundles. Source: docs/orthospectrum.md section 3.
class Reach {
 public:
  /// `shortest`: a lower bound, >= 0, for the lengths of all arcs of the manifold.
  Reach(double length, double shortest);

  double length() const { return length_; }
  double cosh_length() const { return cosh_; }
  /// Fills in where the vertex lies on the base plane, and its room: the square of the sinh of the
  /// distance within which no other arc <= L can have its foot, times sinh^2 d / Z^2.
  void place(Vertex& vertex) const;
  /// Whether every point of the window is too near to the vertex for another arc.
  bool fills(const Vertex& vertex, const Window& window) const;
  /// Whether some ray over the window meets the plane of the face at a distance <= L.
  ///   face  its vertices a, b, c, in the order of Corner::area
  ///   cosh  of the edges bc, ca, ab, as Steps::cosh_length
  bool meets(const std::array<const Vertex*, 3>& face, const std::array<double, 3>& cosh,
             const Window& window) const;

 private:
  double length_, cosh_, sinh_, up_, down_, cosh_shortest_;
};

}  // namespace tripus::orthospectrum::detail
