#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "orthospectrum/detail/halt.hpp"
#include "orthospectrum/detail/steps.hpp"
#include "orthospectrum/detail/window.hpp"

namespace tripus::orthospectrum::detail {

/// An arc as it is found: from the triangle where the search began.
struct Find {
  double length = 0;
  double x = 0, y = 0;                  ///< its foot, in the projective model of Triangle
  std::uint32_t tetrahedron = 0;        ///< where it was found, ...
  int vertex = 0;                       ///< ... the vertex that it runs to, ...
  std::array<double, 4> products{};     ///< ... and <v, w_i> for the pole v of the base plane
  std::span<const std::uint8_t> faces;  ///< crossed one after the other, each of its tetrahedron
};
using VisitFind = std::function<void(const Find&)>;

/// The rays that leave a truncation triangle at right angles, followed depth first. One for each
/// thread: it keeps its stack.
class Unfolding {
 public:
  /// `lids`: of steps, for the shortest arc that `reach` knows of.
  Unfolding(const Steps& steps, const Reach& reach, std::span<const Lid> lids);

  /// Visits each arc of length <= L, as oriented, whose foot lies in the triangle of vertex i of
  /// tetrahedron t, except those along its edges. A foot on a side belongs to the triangle whose
  /// (tetrahedron, vertex, face) is least; a foot on a line between windows to the window on the
  /// side of one point of the triangle, so none is missed or visited twice.
  /// Returns false if it was halted.
  bool search(std::size_t t, int i, const VisitFind& visit, Halt& halt);

  /// Windows so far.
  std::uint64_t window_count() const { return windows_; }

 private:
  struct Node {
    std::array<Vertex, 3> face;  ///< counterclockwise, seen from above the base plane
    Vertex behind;               ///< the vertex opposite to the face
    std::array<std::uint8_t, 3> labels{};
    std::uint8_t opposite = 0;
    std::uint32_t tetrahedron = 0;
    std::uint32_t depth = 0;
    std::size_t window = 0;  ///< where its window begins in corners_, which it ends
  };

  void begin(std::size_t t, int i);
  void expand(const Node& node, const VisitFind& visit);
  Vertex beyond(const Node& node, const Step& step) const;
  void measure(const Node& node, const Vertex& apex);
  void look_at(const Node& node, const Step& step, const Vertex& apex, const VisitFind& visit);
  void push_child(const Node& node, const Step& step, const Vertex& apex, std::size_t k);
  bool is_lidded(const Node& next) const;
  void set_kind(Vertex& vertex, std::size_t t, int i) const;
  bool holds(double x, double y) const;

  const Steps& steps_;
  const Reach& reach_;
  std::span<const Lid> lids_;
  std::vector<Node> stack_;
  std::vector<Corner> corners_;      // the windows of the stack, one after the other
  std::vector<std::uint8_t> faces_;  // crossed on the way to the current node
  Window window_, child_, scratch_;
  // Of the window, as seen from the apex beyond its face: towards the vertices of the face, and for
  // each corner twice the areas that it spans with them.
  std::array<double, 3> toward_x_{}, toward_y_{};
  std::vector<std::array<double, 3>> turns_;
  std::size_t base_tetrahedron_ = 0;
  int base_vertex_ = 0;
  double inner_x_ = 0, inner_y_ = 0;  // the point that settles ties
  std::uint64_t windows_ = 0;
};

}  // namespace tripus::orthospectrum::detail
