#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "viewer/inside/inside_options.hpp"
#include "viewer/keys.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// What a change of the view asks for.
enum class Change : std::uint8_t {
  kNothing,
  kPicture,  ///< another frame
  kPlaces,   ///< the cells moved
  kScene,    ///< other cells, or another model
};

/// What a window shows, and how keys and pointers change it: the window without a window.
struct ViewState {
  PictureOptions shown;
  std::size_t cells = 1;
  geometry::Matrix4 motion = geometry::Matrix4::Identity();  ///< of all cells
  std::shared_ptr<const InsideManifold> manifold = nullptr;  ///< null: no view from inside
  bool is_inside = false;                                    ///< needs the manifold
  InsideOptions inside = {};
  bool help = false;
  bool rate = false;  ///< whether frames are counted on screen

  /// Does what a key asks for, except kPicture, kLink and kTransparent, which need a window.
  ///   first  what was shown first
  ///   focus  the ball that the camera looks at
  Change act(KeyAction action, const ViewState& first, const BoundingBall& focus);

  /// Degrees; inside one turns, to the right and upwards.
  Change turn(double across, double up);
  /// Of the picture, in halves of its height.
  Change shift(double right, double up);
  /// Inside: clockwise, degrees.
  Change roll(double clockwise);
  /// By a factor, while what is at (x, y) stays there: in halves of the picture's height from its
  /// middle. Inside one walks.
  Change zoom(double factor, double x = 0, double y = 0);
  /// Moves the cells by a hyperbolic distance, against the direction (right, up, forward) of
  /// flight; inside one walks.
  Change fly(const Vector3& direction, double distance);

  /// Options of `tripus view` that show this very view.
  std::string as_options() const;
};

}  // namespace tripus::viewer
