#include "viewer/window/window.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "viewer/detail/gl.hpp"
#include "viewer/detail/renderer.hpp"
#include "viewer/keys.hpp"
#include "viewer/legend.hpp"
#include "viewer/scene_words.hpp"

// After GLEW.
#include <GLFW/glfw3.h>

#include "viewer/window/detail/text.hpp"
#include "viewer/window/pace.hpp"
#include "viewer/window/slider.hpp"
#include "viewer/window/view_state.hpp"

namespace tripus::viewer {
namespace {

/// What rests is drawn with four samples a pixel, if one took no longer than this, in milliseconds.
constexpr double kFineWithin = 250;
/// A key's step of a Moebius move, hyperbolic length.
constexpr double kStep = 0.06;

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
        first_{options.picture, options.cells, options.motion},
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
            said_ = describe(scene_, (*found)[0], (*found)[1]);
            stale_ = true;
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
    renderer_.set_scene(scene_, state_.shown.model);
    stale_ = true;
  }

  /// Breaks a text at blanks, where it can.
  static std::string in_lines(std::string text, std::size_t letters) {
    for (std::size_t begin = 0; begin + letters < text.size();) {
      std::size_t blank = text.rfind(' ', begin + letters);
      if (blank == std::string::npos || blank <= begin) blank = text.find(' ', begin + letters);
      if (blank == std::string::npos) break;
      text[blank] = '\n';
      begin = blank + 1;
    }
    return text;
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
    const KeyAction action = window_action(character);
    if (action == KeyAction::kPicture) save();
    if (action == KeyAction::kLink) link();
    if (action == KeyAction::kTransparent) make_transparent();
    take(state_.act(action, first_, renderer_.scene_ball()));
  }

  /// Keys without a character.
  void press(int key) {
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window_, GLFW_TRUE);
    const int across = key == GLFW_KEY_RIGHT ? 1 : key == GLFW_KEY_LEFT ? -1 : 0;
    const int up = key == GLFW_KEY_UP ? 1 : key == GLFW_KEY_DOWN ? -1 : 0;
    if (across == 0 && up == 0) return;
    moving_ = true;
    take(state_.turn(5.0 * across, 5.0 * up));
  }

  /// Of the pointer, in halves of the window's height from its middle.
  Eigen::Vector2d pointer() const {
    int width = 1, height = 1;
    glfwGetWindowSize(window_, &width, &height);
    return Eigen::Vector2d(2 * mouse_.x() - width, height - 2 * mouse_.y()) / std::max(height, 1);
  }

  void scroll(double up) {
    moving_ = true;
    const Eigen::Vector2d at = pointer();
    take(state_.zoom(std::exp(0.12 * up), at.x(), at.y()));
  }

  bool is_held(int button) const { return glfwGetMouseButton(window_, button) == GLFW_PRESS; }

  void click(int button, int action) {
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    const auto [width, height] = window_size();
    sliding_ = action == GLFW_PRESS && is_on_slider(mouse_.x(), mouse_.y(), width, height);
    if (sliding_) slide();
  }

  void slide() {
    const auto [width, height] = window_size();
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
    if (left && !shifted) {
      take(state_.turn(-0.35 * step.x(), 0.35 * step.y()));
    } else {
      const double height = window_size()[1];
      take(state_.shift(2 * step.x() / height, -2 * step.y() / height));
    }
  }

  std::array<int, 2> window_size() const {
    std::array<int, 2> size{1, 1};
    glfwGetWindowSize(window_, size.data(), &size[1]);
    return {std::max(size[0], 1), std::max(size[1], 1)};
  }

  void forget_pointer() {
    asked_ = false;
    if (said_.empty()) return;
    said_.clear();
    stale_ = true;
  }

  /// What the pointer rests on: the cell and the wall, or nothing.
  std::optional<std::array<std::size_t, 2>> under_pointer() {
    const auto [width, height] = window_size();
    const Image image = identities();
    const int x = static_cast<int>(mouse_.x() * image.width / width);
    const int y = static_cast<int>(mouse_.y() * image.height / height);
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return std::nullopt;
    const std::uint8_t* const pixel =
        image.pixels.data() +
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(x));
    const std::size_t cell = pixel[0] + 256U * pixel[1];
    if (cell == 0 || cell > scene_.cells.size()) return std::nullopt;
    return {{cell - 1, (pixel[2] & 15U) - 1}};
  }

  /// Which cells and walls the pixels of the window show.
  Image identities() {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    Frame frame;
    frame.width = std::max(width, 1);
    frame.height = std::max(height, 1);
    frame.identities = true;
    const RenderTarget target = make_render_target(frame.width, frame.height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    renderer_.draw(state_.shown, frame);
    Image image = read_pixels(frame.width, frame.height);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
  }

  void make_transparent() {
    if (state_.shown.renderer == RendererKind::kOpenCsg) return;
    if (state_.shown.transparent) {
      state_.shown.transparent.reset();
    } else if (const auto found = under_pointer()) {
      state_.shown.transparent = scene_.cells[(*found)[0]].tetrahedron;
    }
    take(Change::kPicture);
  }

  void link() {
    const std::string command = options_.command + " " + state_.as_options();
    glfwSetClipboardString(window_, command.c_str());
    say("copied: " + command);
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
    const int scale = std::max(1, height / 500);
    draw_text(status(), 10, 10, scale, width, height);
    const float line = 18.0F * static_cast<float>(scale);
    const std::string& said = message_.empty() ? said_ : message_;
    if (!said.empty()) {
      // Letters are some 6 wide; the slider is beside them.
      const auto letters = static_cast<std::size_t>(std::max(20, (width / scale - 250) / 6));
      const std::string lines = in_lines(said, letters);
      const auto count = 1 + std::ranges::count(lines, '\n');
      draw_text(lines, 10, static_cast<float>(height) - static_cast<float>(count) * line, scale,
                width, height);
    }
    const auto [window_width, window_height] = window_size();
    draw_legend(slider(state_.cells, window_width, window_height,
                       static_cast<float>(height) / static_cast<float>(window_height)),
                width, height);
    if (state_.shown.labels && !moving_)
      draw_legend(rectangles_of(labels_of(scene_, state_.shown, identities()), scale), width,
                  height);
    if (scene_.discs != nullptr && state_.shown.discs)
      draw_legend(legend_of(*scene_.discs, width, height), width, height);
    if (state_.help) {
      const auto columns = window_help();
      draw_text(columns[0], 10, 10 + line, scale, width, height);
      draw_text(columns[1], 10 + 130.0F * static_cast<float>(scale), 10 + line, scale, width,
                height);
    }
    glfwSwapBuffers(window_);
  }

  std::string status() const {
    std::string text = fmt::format("{}: {} cells", scene_.title, scene_.cells.size());
    if (state_.rate)
      text += fmt::format(", {:.0f} frames a second", 1000 / std::max(last_took_, 0.1));
    else
      text += fmt::format(", {:.0f} ms", last_took_);
    if (!state_.help) text += "     H: help";
    return text;
  }

  void draw_scene(int width, int height, double quality) {
    // In steps of 8 pixels, so that textures last for some frames.
    const auto coarse = [&](int side) {
      return quality < 1 ? std::clamp(8 * static_cast<int>(quality * side / 8), 8, side) : side;
    };
    Frame frame;
    frame.width = coarse(width);
    frame.height = coarse(height);
    frame.samples = state_.shown.samples > 0 ? state_.shown.samples : fine_ ? 2 : 1;
    if (quality >= 1) {
      renderer_.draw(state_.shown, frame);
      return;
    }
    if (coarse_.width != frame.width || coarse_.height != frame.height)
      coarse_ = make_render_target(frame.width, frame.height);
    glBindFramebuffer(GL_FRAMEBUFFER, coarse_.framebuffer.name());
    renderer_.draw(state_.shown, frame);
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
    add_legend(scene_, state_.shown, image);
    if (state_.shown.labels)
      paint(image,
            rectangles_of(labels_of(scene_, state_.shown, identities()), label_scale(height)));
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
  Renderer renderer_;
  Scene source_;  // before moves
  Scene scene_;
  Eigen::Vector2d mouse_ = Eigen::Vector2d::Zero();
  RenderTarget coarse_;  // what is drawn into while things move
  double quality_ = 1;   // of the next frame then
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
  require_drawable(scene_of(options.cells, options.picture.model), options.picture, options.width,
                   options.height);
  const Glfw glfw(options.width, options.height);
  Viewer(glfw.window(), scene_of, options).run();
}

}  // namespace tripus::viewer
