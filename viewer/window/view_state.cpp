#include "viewer/window/view_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "geometry/moebius.hpp"

namespace tripus::viewer {
namespace {

/// Farther from where they were cells are lost at the boundary of the model: the hyperbolic cosine.
constexpr double kFarthestMove = 1000;

constexpr const char* kColourNames[kColourByCount] = {"tetrahedron", "face", "depth", "component",
                                                      "edge"};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The hyperbolic translation of the origin by a distance in a direction of unit length.
geometry::Matrix4 translation(const Vector3& direction, double distance) {
  geometry::Matrix4 matrix = geometry::Matrix4::Identity();
  matrix.topLeftCorner<3, 3>() += (std::cosh(distance) - 1) * direction * direction.transpose();
  matrix.topRightCorner<3, 1>() = std::sinh(distance) * direction;
  matrix.bottomLeftCorner<1, 3>() = std::sinh(distance) * direction.transpose();
  matrix(3, 3) = std::cosh(distance);
  return matrix;
}

}  // namespace

Change ViewState::act(KeyAction action, const ViewState& first, const BoundingBall& focus) {
  const auto other_cells = [&](std::size_t wanted) {
    cells = std::clamp<std::size_t>(wanted, 1, kMostDrawnCells);
    return Change::kScene;
  };
  switch (action) {
    case KeyAction::kNone:
    case KeyAction::kPicture:
    case KeyAction::kLink:
    case KeyAction::kTransparent:
      return Change::kNothing;
    case KeyAction::kChangeView:
      if (manifold == nullptr) return Change::kNothing;
      is_inside = !is_inside;
      break;
    case KeyAction::kNearer:
      return zoom(1.12);
    case KeyAction::kFarther:
      return zoom(1 / 1.12);
    case KeyAction::kFewerCells:
      return other_cells(cells - std::min(cells - 1, std::max<std::size_t>(1, cells / 5)));
    case KeyAction::kMoreCells:
      return other_cells(cells + std::max<std::size_t>(1, cells / 4));
    case KeyAction::kChangeModel:
      shown.model = static_cast<Model>((static_cast<int>(shown.model) + 1) % 3);
      shown.cut_away.reset();
      return Change::kScene;
    case KeyAction::kChangeColour: {
      // OpenCSG has no colours for edges, the last.
      const int count = kColourByCount - (shown.renderer == RendererKind::kOpenCsg ? 1 : 0);
      shown.colour_by = static_cast<ColourBy>((static_cast<int>(shown.colour_by) + 1) % count);
      break;
    }
    case KeyAction::kFaces:
      shown.faces = !shown.faces || !shown.truncations;
      break;
    case KeyAction::kTruncations:
      shown.truncations = !shown.truncations || !shown.faces;
      break;
    case KeyAction::kDiscs:
      shown.discs = !shown.discs;
      break;
    case KeyAction::kLines:
      if (shown.renderer == RendererKind::kOpenCsg) return Change::kNothing;
      shown.lines = !shown.lines;
      break;
    case KeyAction::kHollow:
      shown.drawing = shown.drawing == Material::kSolid ? Material::kHollow : Material::kSolid;
      break;
    case KeyAction::kNooks:
      shown.occlusion = !shown.occlusion;
      break;
    case KeyAction::kCut:
      if (shown.cut_away)
        shown.cut_away.reset();
      else
        shown.cut_away = focus.centre.x();
      break;
    case KeyAction::kCutBack:
    case KeyAction::kCutForth:
      if (!shown.cut_away) return Change::kNothing;
      *shown.cut_away += (action == KeyAction::kCutForth ? 0.04 : -0.04) * focus.radius;
      break;
    case KeyAction::kLabels:
      shown.labels = !shown.labels;
      break;
    case KeyAction::kFirstView: {
      inside = first.inside;
      const bool was_moved = motion != first.motion;
      shown.camera = first.shown.camera;
      motion = first.motion;
      return was_moved ? Change::kPlaces : Change::kPicture;
    }
    case KeyAction::kTheme:
      shown.dark = !shown.dark;
      break;
    case KeyAction::kRate:
      rate = !rate;
      break;
    case KeyAction::kHelp:
      help = !help;
      break;
  }
  return Change::kPicture;
}

Change ViewState::turn(double across, double up) {
  if (is_inside) {
    inside.walker.turn(radians(across), radians(up));
    return Change::kPicture;
  }
  shown.camera.azimuth = std::remainder(shown.camera.azimuth + across, 360);
  shown.camera.elevation = std::clamp(shown.camera.elevation + up, -89.0, 89.0);
  return Change::kPicture;
}

Change ViewState::roll(double clockwise) {
  if (!is_inside) return Change::kNothing;
  inside.walker.turn(0, 0, radians(clockwise));
  return Change::kPicture;
}

Change ViewState::shift(double right, double up) {
  if (is_inside) return Change::kNothing;
  shown.camera.shift += Eigen::Vector2d(right, up);
  return Change::kPicture;
}

Change ViewState::zoom(double factor, double x, double y) {
  if (is_inside) return fly(Vector3(0, 0, factor > 1 ? 1 : -1), std::abs(std::log(factor)));
  Camera& camera = shown.camera;
  const double before = camera.zoom;
  camera.zoom = std::clamp(before * factor, kLeastZoom, kMostZoom);
  const Eigen::Vector2d at(x, y);
  camera.shift = at - camera.zoom / before * (at - camera.shift);
  return Change::kPicture;
}

Change ViewState::fly(const Vector3& direction, double distance) {
  if (is_inside) {
    inside.walker.walk(*manifold, direction, distance);
    return Change::kPicture;
  }
  if (shown.renderer == RendererKind::kOpenCsg) return Change::kNothing;
  const View view = view_of(shown.camera, BoundingBall{Vector3::Zero(), 1}, 1, 1);
  const Vector3 in_eye_space(direction.x(), direction.y(), -direction.z());
  const Vector3 way =
      (view.model_view.topLeftCorner<3, 3>().transpose() * in_eye_space).normalized();
  const geometry::Matrix4 there = geometry::reorthogonalised(translation(way, -distance) * motion);
  if (there(3, 3) > kFarthestMove) return Change::kNothing;
  motion = there;
  return Change::kPlaces;
}

std::string ViewState::as_options() const {
  const Camera& camera = shown.camera;
  std::string text = fmt::format("--model {} --cells {} --camera {:.6g},{:.6g},{:.6g}",
                                 geometry::to_string(shown.model), cells, camera.azimuth,
                                 camera.elevation, camera.distance);
  if (camera.zoom != 1 || !camera.shift.isZero())
    text += fmt::format(",{:.6g},{:.6g},{:.6g}", camera.zoom, camera.shift.x(), camera.shift.y());
  if (shown.colour_by != ColourBy::kTetrahedron)
    text += fmt::format(" --colour-by {}", kColourNames[static_cast<int>(shown.colour_by)]);
  if (shown.renderer == RendererKind::kOpenCsg) text += " --renderer opencsg";
  if (!shown.faces) text += " --no-faces";
  if (!shown.truncations) text += " --no-truncations";
  if (!shown.lines) text += " --no-lines";
  if (shown.drawing == Material::kHollow) text += " --hollow";
  if (shown.cut_away) text += fmt::format(" --cut-away {:.6g}", *shown.cut_away);
  if (shown.transparent) text += fmt::format(" --transparent {}", *shown.transparent);
  if (shown.labels) text += " --labels";
  if (shown.dark) text += " --dark";
  if (is_inside) {
    text += fmt::format(" --inside {}", inside.walker.tetrahedron);
    for (int k = 0; k < 16; ++k) text += fmt::format(",{:.12g}", inside.walker.frame(k / 4, k % 4));
  }
  if (motion != geometry::Matrix4::Identity()) {
    const geometry::MoebiusMap map = geometry::to_moebius(motion, false);
    text +=
        fmt::format(" --moebius {:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}",
                    map.a.real(), map.a.imag(), map.b.real(), map.b.imag(), map.c.real(),
                    map.c.imag(), map.d.real(), map.d.imag());
  }
  return text;
}

}  // namespace tripus::viewer
