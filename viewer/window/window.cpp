#include "viewer/window/window.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "viewer/detail/gl.hpp"
#include "viewer/detail/renderer.hpp"
#include "viewer/legend.hpp"

// After GLEW.
#include <GLFW/glfw3.h>

#include "viewer/window/detail/text.hpp"
#include "viewer/window/pace.hpp"

namespace tripus::viewer {
namespace {

constexpr const char* kHelp =
    "drag, arrows     turn\n"
    "right drag       shift\n"
    "wheel            zoom\n"
    "+  -             more or fewer cells\n"
    "M                upper half-space, ball, Klein ball\n"
    "C                colour by tetrahedron, face, depth\n"
    "F  T             faces, truncations on and off\n"
    "D                discs of arcs on and off\n"
    "X  [  ]          cut away, move the cut\n"
    "S                solid or hollow\n"
    "O                dark nooks on and off\n"
    "R                first view again\n"
    "P                save a picture\n"
    "H                this help\n"
    "Esc  Q           close";

/// What rests is drawn with four samples a pixel, if one took no longer than this, in milliseconds.
constexpr double kFineWithin = 250;

/// GLFW and its window, closed in the right order whatever happens.
class Glfw {
 public:
  Glfw(int width, int height) {
    glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
    if (glfwInit() == GLFW_FALSE) fail("no display here");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    window_ = glfwCreateWindow(width, height, "Tripus", nullptr, nullptr);
    if (window_ == nullptr) fail("no window with OpenGL here");
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
  }
  ~Glfw() { close(); }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
  GLFWwindow* window() const { return window_; }

 private:
  static std::string& last_error() {
    static std::string text;
    return text;
  }
  [[noreturn]] void fail(const std::string& what) {
    const std::string reason = last_error().empty() ? "" : " (" + last_error() + ")";
    close();
    throw NoOpenGl(what + reason +
                   "; draw a picture with --png out.png, or write a page for a browser with "
                   "-o page.html");
  }
  void close() {
    if (window_ != nullptr) glfwDestroyWindow(window_);
    window_ = nullptr;
    glfwTerminate();
  }

  GLFWwindow* window_ = nullptr;
};

/// What the user sees and does.
class Viewer {
 public:
  Viewer(GLFWwindow* window, const SceneSource& scene_of, const WindowOptions& options)
      : window_(window),
        scene_of_(scene_of),
        options_(options),
        first_(options.picture),
        shown_(options.picture),
        cells_(options.cells) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      if (action != GLFW_RELEASE) of(w).guarded([&](Viewer& viewer) { viewer.press(key); });
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double up) {
      of(w).guarded([&](Viewer& viewer) { viewer.zoom(up); });
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
        }
      }
      if (failure_) std::rethrow_exception(failure_);
      const std::atomic<bool>* const stop = options_.picture.stop_requested;
      if (stop != nullptr && stop->load()) return;
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
    scene_ = scene_of_(cells_, shown_.model);
    renderer_.set_scene(scene_, shown_.model);
    stale_ = true;
  }

  void set_cells(std::size_t wanted) {
    cells_ = std::clamp<std::size_t>(wanted, 1, kMostCells);
    load();
  }

  void press(int key) {
    Camera& camera = shown_.camera;
    stale_ = true;
    switch (key) {
      case GLFW_KEY_ESCAPE:
      case GLFW_KEY_Q:
        glfwSetWindowShouldClose(window_, GLFW_TRUE);
        break;
      case GLFW_KEY_EQUAL:
      case GLFW_KEY_KP_ADD:
        set_cells(cells_ + std::max<std::size_t>(1, cells_ / 4));
        break;
      case GLFW_KEY_MINUS:
      case GLFW_KEY_KP_SUBTRACT:
        set_cells(cells_ - std::max<std::size_t>(cells_ > 1 ? 1 : 0, cells_ / 5));
        break;
      case GLFW_KEY_M:
        shown_.model = static_cast<Model>((static_cast<int>(shown_.model) + 1) % 3);
        load();
        break;
      case GLFW_KEY_C:
        shown_.colour_by = static_cast<ColourBy>((static_cast<int>(shown_.colour_by) + 1) % 3);
        break;
      case GLFW_KEY_F:
        if (shown_.truncations) shown_.faces = !shown_.faces;
        break;
      case GLFW_KEY_T:
        if (shown_.faces) shown_.truncations = !shown_.truncations;
        break;
      case GLFW_KEY_D:
        shown_.discs = !shown_.discs;
        break;
      case GLFW_KEY_X:
        if (shown_.cut_away)
          shown_.cut_away.reset();
        else
          shown_.cut_away = renderer_.scene_ball().centre.x();
        break;
      case GLFW_KEY_LEFT_BRACKET:
      case GLFW_KEY_RIGHT_BRACKET:
        if (shown_.cut_away)
          *shown_.cut_away +=
              (key == GLFW_KEY_RIGHT_BRACKET ? 0.04 : -0.04) * renderer_.scene_ball().radius;
        break;
      case GLFW_KEY_S:
        shown_.drawing = shown_.drawing == Drawing::kSolid ? Drawing::kHollow : Drawing::kSolid;
        break;
      case GLFW_KEY_O:
        shown_.occlusion = !shown_.occlusion;
        break;
      case GLFW_KEY_R:
        shown_.camera = first_.camera;
        break;
      case GLFW_KEY_P:
        save();
        break;
      case GLFW_KEY_H:
        help_ = !help_;
        break;
      case GLFW_KEY_LEFT:
        camera.azimuth -= 5;
        moving_ = true;
        break;
      case GLFW_KEY_RIGHT:
        camera.azimuth += 5;
        moving_ = true;
        break;
      case GLFW_KEY_UP:
        camera.elevation = std::min(camera.elevation + 5, 89.0);
        moving_ = true;
        break;
      case GLFW_KEY_DOWN:
        camera.elevation = std::max(camera.elevation - 5, -89.0);
        moving_ = true;
        break;
      default:
        break;
    }
  }

  void zoom(double up) {
    moving_ = true;
    shown_.camera.zoom = std::clamp(shown_.camera.zoom * std::exp(0.12 * up), 0.2, 200.0);
    stale_ = true;
  }

  void move(double x, double y) {
    const Eigen::Vector2d step(x - mouse_.x(), y - mouse_.y());
    mouse_ = {x, y};
    Camera& camera = shown_.camera;
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
      camera.azimuth -= 0.35 * step.x();
      camera.elevation = std::clamp(camera.elevation + 0.35 * step.y(), -89.0, 89.0);
      stale_ = moving_ = true;
    } else if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS) {
      int width = 1, height = 1;
      glfwGetWindowSize(window_, &width, &height);
      camera.shift += 2 * Eigen::Vector2d(step.x(), -step.y()) / std::max(height, 1);
      stale_ = moving_ = true;
    }
  }

  /// `quality`: the share of the pixels across.
  void draw(double quality) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    if (width < 1 || height < 1) return;  // minimised
    const auto start = std::chrono::steady_clock::now();
    draw_scene(width, height, quality);
    glFinish();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    last_took_ = took.count();
    if (moving_) quality_ = next_quality(quality, last_took_);
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "%zu cells, %.0f ms%s", scene_.cells.size(), last_took_,
                  help_ ? "" : "     H: help");
    const int scale = std::max(1, height / 500);
    draw_text(scene_.title + ": " + line.data() + (message_.empty() ? "" : "     " + message_), 10,
              10, scale, width, height);
    if (scene_.discs != nullptr && shown_.discs)
      draw_legend(legend_of(*scene_.discs, width, height), width, height);
    if (help_) draw_text(kHelp, 10, 10 + 18.0F * static_cast<float>(scale), scale, width, height);
    glfwSwapBuffers(window_);
  }

  void draw_scene(int width, int height, double quality) {
    // In steps of 8 pixels, so that textures last for some frames.
    const auto coarse = [&](int side) {
      return quality < 1 ? std::clamp(8 * static_cast<int>(quality * side / 8), 8, side) : side;
    };
    Frame frame;
    frame.width = coarse(width);
    frame.height = coarse(height);
    frame.samples = shown_.samples > 0 ? shown_.samples : fine_ ? 2 : 1;
    if (quality >= 1) {
      renderer_.draw(shown_, frame);
      return;
    }
    if (coarse_.width != frame.width || coarse_.height != frame.height)
      coarse_ = make_render_target(frame.width, frame.height);
    glBindFramebuffer(GL_FRAMEBUFFER, coarse_.framebuffer.name());
    renderer_.draw(shown_, frame);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, coarse_.framebuffer.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, frame.width, frame.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
  }

  /// What the window shows, without the text.
  void save() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    if (width < 1 || height < 1) return;
    draw_scene(width, height, 1);
    Image image = read_pixels(width, height);
    add_legend(scene_, shown_, image);
    namespace fs = std::filesystem;
    for (int number = 1;; ++number) {
      const fs::path path =
          fs::path(options_.picture_folder) / ("tripus-" + std::to_string(number) + ".png");
      std::error_code status;
      if (fs::exists(path, status)) continue;
      try {
        write_png(image, path.string());
        message_ = "saved " + path.string();
      } catch (const InvalidInput& error) {
        message_ = error.what();  // no reason to close the window
      }
      return;
    }
  }

  GLFWwindow* window_;
  const SceneSource& scene_of_;
  WindowOptions options_;
  PictureOptions first_;
  PictureOptions shown_;
  std::size_t cells_;
  Renderer renderer_;
  Scene scene_;
  Eigen::Vector2d mouse_ = Eigen::Vector2d::Zero();
  RenderTarget coarse_;  // what is drawn into while things move
  double quality_ = 1;   // of the next frame then
  bool moving_ = false;
  bool fine_ = false;     // four samples a pixel, while nothing changes
  double last_took_ = 0;  // milliseconds
  bool stale_ = true;
  bool help_ = true;
  std::string message_;
  std::exception_ptr failure_;
};

}  // namespace

void show_window(const SceneSource& scene_of, const WindowOptions& options) {
  require_drawable(scene_of(options.cells, options.picture.model), options.picture, options.width,
                   options.height);
  const Glfw glfw(options.width, options.height);
  Viewer(glfw.window(), scene_of, options).run();
}

}  // namespace tripus::viewer
