#include "viewer/window/window.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "viewer/keys.hpp"
#include "viewer/legend.hpp"
#include "viewer/scene_words.hpp"
#include "viewer/window/detail/canvas.hpp"
#include "viewer/window/detail/glfw_window.hpp"
#include "viewer/window/detail/overlay.hpp"
#include "viewer/window/pace.hpp"
#include "viewer/window/slider.hpp"
#include "viewer/window/view_state.hpp"

// After GLEW.
#include <GLFW/glfw3.h>

namespace tripus::viewer {
namespace {

/// What rests is drawn with four samples a pixel, if one took no longer than this, in milliseconds.
constexpr double kFineWithin = 250;
/// A key's step of a Moebius move, hyperbolic length.
constexpr double kStep = 0.06;

/// What the user sees and does.
class Viewer {
 public:
  Viewer(GLFWwindow* window, const SceneSource& scene_of, const WindowOptions& options)
      : window_(window),
        scene_of_(scene_of),
        options_(options),
        first_{options.picture,  options.cells,     options.motion,
               options.manifold, options.is_inside, options.inside},
        state_(first_) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      if (action != GLFW_RELEASE) of(w).guarded([&](Viewer& viewer) { viewer.press(key); });
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
      of(w).guarded([&](Viewer& viewer) { viewer.type(character); });
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
      of(w).guarded([&](Viewer& viewer) { viewer.click(button, action); });
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double up) {
      of(w).guarded([&](Viewer& viewer) { viewer.scroll(up); });
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
      of(w).guarded([&](Viewer& viewer) { viewer.move(x, y); });
    });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).stale_ = true; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).stale_ = true; });
    load();
  }

  void run() {
    int frames = 0;
    while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
      if (stale_) {
        stale_ = false;
        draw(moving_ ? quality_ : 1);
        ++frames;
      }
      if (options_.most_frames > 0 && frames >= options_.most_frames) break;
      if (stale_ || options_.most_frames > 0) {
        stale_ = true;
        glfwPollEvents();
      } else {
        // What rests for a while is drawn with all pixels.
        glfwWaitEventsTimeout(moving_ ? 0.2 : 0.5);
        if (stale_) {
          fine_ = false;
        } else if (moving_ || (!fine_ && last_took_ < kFineWithin)) {
          fine_ = !moving_;
          moving_ = false;
          stale_ = true;
        } else if (!asked_) {
          asked_ = true;
          if (const auto found = under_pointer()) {
            said_ = describe(scene_, found->cell, found->wall);
            stale_ = true;
          } else if (state_.is_inside) {
            said_ = met_under_pointer();
            stale_ = !said_.empty();
          }
        }
      }
      if (failure_) std::rethrow_exception(failure_);
      if (options_.picture.stop.requested()) return;
    }
  }

 private:
  static Viewer& of(GLFWwindow* window) {
    return *static_cast<Viewer*>(glfwGetWindowUserPointer(window));
  }

  /// Exceptions do not pass through GLFW, which is C; they are thrown again in run().
  template <class Action>
  void guarded(Action&& action) {
    try {
      action(*this);
    } catch (...) {
      failure_ = std::current_exception();
    }
  }

  void load() {
    source_ = scene_of_(state_.cells, state_.shown.model);
    place();
  }

  void say(std::string message) {
    message_ = std::move(message);
    stale_ = true;
  }

  /// Puts the cells where the moves want them.
  void place() {
    scene_ = moved(state_.shown.model, source_, state_.motion);
    canvas_.set_scene(scene_, state_.shown.model);
    stale_ = true;
  }

  void take(Change change) {
    if (change == Change::kScene) load();
    if (change == Change::kPlaces) place();
    if (change == Change::kNothing) return;
    message_.clear();
    forget_pointer();
    stale_ = true;
  }

  void type(char32_t character) {
    constexpr std::u32string_view kWays = U"wasdrf";
    const std::array<Vector3, 6> ways{Vector3(0, 0, 1), Vector3(-1, 0, 0), Vector3(0, 0, -1),
                                      Vector3(1, 0, 0), Vector3(0, 1, 0),  Vector3(0, -1, 0)};
    const char32_t small = character >= 'A' && character <= 'Z' ? character + 32 : character;
    if (const std::size_t way = kWays.find(small); way != std::u32string_view::npos) {
      moving_ = true;
      take(state_.fly(ways[way], kStep));
      return;
    }
    if (state_.is_inside && (small == 'q' || small == 'e')) {
      moving_ = true;
      take(state_.roll(small == 'q' ? -5 : 5));
      return;
    }
    const KeyAction action = window_action(character);
    if (action == KeyAction::kPicture) save();
    if (action == KeyAction::kLink) link();
    if (action == KeyAction::kTransparent) make_transparent();
    take(state_.act(action, first_, canvas_.scene_ball()));
  }

  /// Keys without a character.
  void press(int key) {
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window_, GLFW_TRUE);
    const int across = key == GLFW_KEY_RIGHT ? 1 : key == GLFW_KEY_LEFT ? -1 : 0;
    const int up = key == GLFW_KEY_UP ? 1 : key == GLFW_KEY_DOWN ? -1 : 0;
    if (across == 0 && up == 0) return;
    moving_ = true;
    if (state_.is_inside && up != 0)
      take(state_.fly(Vector3(0, 0, up), kStep));
    else
      take(state_.turn(5.0 * across, 5.0 * up));
  }

  /// Of the pointer, in halves of the window's height from its middle.
  Eigen::Vector2d pointer() const {
    const auto [width, height] = window_size(window_);
    return Eigen::Vector2d(2 * mouse_.x() - width, height - 2 * mouse_.y()) / height;
  }

  void scroll(double up) {
    moving_ = true;
    const Eigen::Vector2d at = pointer();
    take(state_.zoom(std::exp(0.12 * up), at.x(), at.y()));
  }

  bool is_held(int button) const { return glfwGetMouseButton(window_, button) == GLFW_PRESS; }

  void click(int button, int action) {
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    const auto [width, height] = window_size(window_);
    sliding_ = action == GLFW_PRESS && is_on_slider(mouse_.x(), mouse_.y(), width, height);
    if (sliding_) slide();
  }

  void slide() {
    const auto [width, height] = window_size(window_);
    const std::size_t wanted = slider_value(mouse_.x(), width, height);
    if (wanted == state_.cells) return;
    state_.cells = wanted;
    moving_ = true;
    take(Change::kScene);
  }

  void move(double x, double y) {
    const Eigen::Vector2d step(x - mouse_.x(), y - mouse_.y());
    mouse_ = {x, y};
    forget_pointer();
    if (sliding_) {
      slide();
      return;
    }
    const bool shifted = glfwGetKey(window_, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                         glfwGetKey(window_, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
    const bool left = is_held(GLFW_MOUSE_BUTTON_LEFT);
    if (!left && !is_held(GLFW_MOUSE_BUTTON_RIGHT)) return;
    moving_ = true;
    if (state_.is_inside) {
      // As in pages, a height of the window is 1.6 radians.
      const double degrees = 1.6 * 180 / std::numbers::pi / window_size(window_)[1];
      take(state_.turn(-degrees * step.x(), degrees * step.y()));
    } else if (left && !shifted) {
      take(state_.turn(-0.35 * step.x(), 0.35 * step.y()));
    } else {
      const double height = window_size(window_)[1];
      take(state_.shift(2 * step.x() / height, -2 * step.y() / height));
    }
  }

  void forget_pointer() {
    asked_ = false;
    if (said_.empty()) return;
    said_.clear();
    stale_ = true;
  }

  /// What the pointer rests on, or nothing.
  std::optional<SeenWall> under_pointer() {
    if (state_.is_inside) return std::nullopt;
    const auto [width, height] = window_size(window_);
    const Image image = identities();
    const auto seen = seen_at(image, static_cast<int>(mouse_.x() * image.width / width),
                              static_cast<int>(mouse_.y() * image.height / height));
    if (!seen || seen->cell >= scene_.cells.size()) return std::nullopt;
    return seen;
  }

  /// What the pointer rests on inside, in words.
  std::string met_under_pointer() {
    const auto [width, height] = window_size(window_);
    const Image image = identities();
    const int x = static_cast<int>(mouse_.x() * image.width / width),
              y = static_cast<int>(mouse_.y() * image.height / height);
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return {};
    const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x));
    // Of the tetrahedron's number, a byte.
    if (state_.manifold->tetrahedra.size() > 256) return {};
    return describe_inside(*state_.manifold, image.pixels[at], image.pixels[at + 1],
                           image.pixels[at + 2] & 15U);
  }

  /// Which cells and walls the pixels of the window show.
  Image identities() {
    const auto [width, height] = picture_size(window_);
    look();
    return canvas_.identities(state_.shown, width, height);
  }

  void make_transparent() {
    if (state_.shown.renderer == RendererKind::kOpenCsg || state_.is_inside) return;
    if (state_.shown.transparent) {
      state_.shown.transparent.reset();
    } else if (const auto found = under_pointer()) {
      state_.shown.transparent = scene_.cells[found->cell].tetrahedron;
    }
    take(Change::kPicture);
  }

  void link() {
    std::string command = options_.command + " " + state_.as_options();
    if (scene_.discs != nullptr && state_.shown.discs) command += " " + options_.discs;
    glfwSetClipboardString(window_, command.c_str());
    say("copied: " + command);
  }

  /// `quality`: the share of the pixels across.
  void draw(double quality) {
    const auto [width, height] = picture_size(window_);
    if (width < 1 || height < 1) return;  // minimised
    const auto start = std::chrono::steady_clock::now();
    draw_scene(width, height, quality);
    glFinish();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    last_took_ = took.count();
    if (moving_) quality_ = next_quality(quality, last_took_);
    std::vector<SceneLabel> labels;
    if (state_.shown.labels && !moving_ && !state_.is_inside)
      labels = labels_of(scene_, state_.shown, identities());
    draw_overlay(scene_, state_,
                 {.status = status(),
                  .said = message_.empty() ? said_ : message_,
                  .labels = labels,
                  .picture = {width, height},
                  .window = window_size(window_)});
    glfwSwapBuffers(window_);
  }

  std::string status() const {
    std::string text =
        state_.is_inside
            ? fmt::format("{}: in tetrahedron {}", scene_.title, state_.inside.walker.tetrahedron)
            : fmt::format("{}: {} cells", scene_.title, scene_.cells.size());
    if (state_.rate)
      text += fmt::format(", {:.0f} frames a second", 1000 / std::max(last_took_, 0.1));
    else
      text += fmt::format(", {:.0f} ms", last_took_);
    if (!state_.help) text += "     H: help";
    return text;
  }

  void draw_scene(int width, int height, double quality) {
    const int samples = state_.shown.samples > 0 ? state_.shown.samples : fine_ ? 2 : 1;
    look();
    canvas_.draw(state_.shown, width, height, quality, samples);
  }

  void look() {
    if (state_.is_inside)
      canvas_.look_from_inside(state_.manifold, state_.inside);
    else
      canvas_.look_from_outside();
  }

  /// What the window shows, without the text.
  void save() {
    const auto [width, height] = picture_size(window_);
    if (width < 1 || height < 1) return;
    draw_scene(width, height, 1);
    Image image = read_pixels(width, height);
    add_legend(scene_, state_.shown, image);
    if (state_.shown.labels && !state_.is_inside)
      add_labels(scene_, state_.shown, identities(), image);
    namespace fs = std::filesystem;
    for (int number = 1;; ++number) {
      const fs::path path =
          fs::path(options_.picture_folder) / ("tripus-" + std::to_string(number) + ".png");
      std::error_code status;
      if (fs::exists(path, status)) continue;
      try {
        write_png(image, path.string());
        say("saved " + path.string());
      } catch (const InvalidInput& error) {
        say(error.what());  // no reason to close the window
      }
      return;
    }
  }

  GLFWwindow* window_;
  const SceneSource& scene_of_;
  WindowOptions options_;
  ViewState first_;
  ViewState state_;
  Canvas canvas_;
  Scene source_;  // before moves
  Scene scene_;
  Eigen::Vector2d mouse_ = Eigen::Vector2d::Zero();
  double quality_ = 1;  // of the next frame while things move
  bool moving_ = false;
  bool fine_ = false;     // four samples a pixel, while nothing changes
  double last_took_ = 0;  // milliseconds
  bool stale_ = true;
  bool sliding_ = false;
  bool asked_ = false;  // what the pointer rests on
  std::string said_;    // about it
  std::string message_;
  std::exception_ptr failure_;
};

}  // namespace

void show_window(const SceneSource& scene_of, const WindowOptions& options) {
  const Model model = options.picture.model;
  require_drawable(moved(model, scene_of(options.cells, model), options.motion), options.picture,
                   options.width, options.height);
  const GlfwWindow glfw(options.width, options.height);
  Viewer(glfw.window(), scene_of, options).run();
}

}  // namespace tripus::viewer
