#pragma once

#include <array>
#include <string>

struct GLFWwindow;

namespace tripus::viewer {

/// GLFW and its window with OpenGL, current while it lives; closed in the right order whatever
/// happens.
class GlfwWindow {
 public:
  /// Throws NoOpenGl where there is no display or no OpenGL.
  GlfwWindow(int width, int height);
  ~GlfwWindow() { close(); }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;
  GLFWwindow* window() const { return window_; }

 private:
  [[noreturn]] void fail(const std::string& what);
  void close();

  GLFWwindow* window_ = nullptr;
};

/// Width and height of a window in its own units, at least 1.
std::array<int, 2> window_size(GLFWwindow* window);

/// The same of its picture, in pixels; 0 if it is minimised.
std::array<int, 2> picture_size(GLFWwindow* window);

}  // namespace tripus::viewer
