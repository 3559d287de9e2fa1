#include "viewer/window/detail/glfw_window.hpp"

#include <algorithm>

#include "viewer/picture.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tripus::viewer {
namespace {

std::string& last_error() {
  static std::string text;
  return text;
}

}  // namespace

GlfwWindow::GlfwWindow(int width, int height) {
  glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
  if (glfwInit() == GLFW_FALSE) fail("no display here");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
  window_ = glfwCreateWindow(width, height, "Tripus", nullptr, nullptr);
  if (window_ == nullptr) fail("no window with OpenGL here");
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
}

void GlfwWindow::fail(const std::string& what) {
  const std::string reason = last_error().empty() ? "" : " (" + last_error() + ")";
  close();
  throw NoOpenGl(what + reason +
                 "; draw a picture with --png out.png, or write a page for a browser with "
                 "-o page.html");
}

void GlfwWindow::close() {
  if (window_ != nullptr) glfwDestroyWindow(window_);
  window_ = nullptr;
  glfwTerminate();
}

std::array<int, 2> window_size(GLFWwindow* window) {
  std::array<int, 2> size{1, 1};
  glfwGetWindowSize(window, size.data(), &size[1]);
  return {std::max(size[0], 1), std::max(size[1], 1)};
}

std::array<int, 2> picture_size(GLFWwindow* window) {
  std::array<int, 2> size{0, 0};
  glfwGetFramebufferSize(window, size.data(), &size[1]);
  return size;
}

}  // namespace tripus::viewer
