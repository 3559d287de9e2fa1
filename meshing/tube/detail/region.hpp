#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "base/stop.hpp"
#include "meshing/tube/detail/strands.hpp"

namespace tripus::meshing::tube {

/// What long work calls now and then: throws Stopped when asked to, and shows that it goes on.
class Pulse {
 public:
  Pulse(const Stop& stop = {}, std::function<void()> beat = {})
      : stop_(stop), beat_(std::move(beat)) {}

  void operator()() const {
    throw_if_stopped(stop_);
    if (beat_) beat_();
  }

 private:
  Stop stop_;
  std::function<void()> beat_;
};

/// The piece of space that the surface bounds: inside the outer surface, outside the tube; without
/// an outer surface the tube itself.
class TubeRegion {
 public:
  /// `depth` > 0: values below -depth count as -depth. `fillet` >= 0: `value` rounds the clefts
  /// between strands that part at an acute angle, by balls about as large as this; it grows there
  /// by at most kFilletHeight * fillet, and nowhere else.
  TubeRegion(const TubeStrands& strands, double radius, double depth, double fillet = 0);

  static constexpr double kFilletHeight = 0.25;

  /// Negative inside, 0 on the surface; changes no faster than the place.
  double value(const Point& p) const;

  /// Like `value`, but not cut off at -depth: for ruling out whole cubes.
  double full_value(const Point& p) const;

  /// The point moved onto the surface by Newton steps along the gradient.
  Point projected(Point p) const;

  /// Distance from the graph; `beyond` if it is more than that.
  double graph_distance(const Point& p, double beyond) const;

  double radius() const { return radius_; }
  double fillet() const { return fillet_; }
  Bounds bounds() const;

 private:
  struct Cell {  ///< of a tree of boxes around the segments
    Bounds bounds;
    std::uint32_t first, last;  ///< segments, if a leaf
    std::uint32_t right;        ///< the other child; the left one follows its parent
  };
  struct Nearest {
    double squared;
    std::uint32_t segment;
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  /// Visits the segments (by number) of the cells that are not too far from p.
  template <class TooFar, class Visit>
  void walk(const Point& p, TooFar&& too_far, Visit&& visit) const;
  Nearest nearest(const Point& p, double beyond) const;
  template <class Visit>
  void for_segments_within(const Point& p, double distance, Visit&& visit) const;
  double rounding(const Point& p, const Nearest& near) const;

  std::vector<std::array<Point, 2>> segments_;
  std::vector<Cell> cells_;
  OuterSurface outer_;
  double radius_, depth_, fillet_;
};

}  // namespace tripus::meshing::tube
