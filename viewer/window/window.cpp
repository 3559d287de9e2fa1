#include "viewer/window/window.hpp"

namespace tripus::viewer {
void show_window(const SceneSource&, const WindowOptions&) { throw NoOpenGl("no window yet"); }
}  // namespace tripus::viewer
