#pragma once

#include <functional>
#include <memory>
#include <string>

#include "viewer/inside/inside_options.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

struct WindowOptions {
  PictureOptions picture;
  int width = 1200;
  int height = 900;
  std::size_t cells = 1;                                     ///< to begin with
  std::shared_ptr<const InsideManifold> manifold = nullptr;  ///< null: no view from inside
  bool is_inside = false;                                    ///< to begin with
  InsideOptions inside = {};
  std::string picture_folder;  ///< where the key for it saves pictures; empty: the current one
  geometry::Matrix4 motion = geometry::Matrix4::Identity();  ///< moves all cells, to begin with
  /// What a shell runs for this scene: the key L adds the options of the view.
  std::string command = "tripus view";
  std::string discs = "--discs";  ///< the option for those of the scene, while they are shown
  int most_frames = 0;            ///< closes the window after so many; 0: when the user does
};

/// The scene with so many cells, in a model: called when the user asks for more or another model.
using SceneSource = std::function<Scene(std::size_t cells, Model model)>;

/// Shows a window until it is closed, or picture.stop is true. On screen is what the
/// mouse and the keys do. Throws InvalidInput for what cannot be drawn, and NoOpenGl where there is
/// no display or no OpenGL.
void show_window(const SceneSource& scene_of, const WindowOptions& options);

}  // namespace tripus::viewer
