// What the desktop viewer is in a build without it.
#include "viewer/egl/offscreen.hpp"
#include "viewer/window/window.hpp"

namespace tripus::viewer {
namespace {

[[noreturn]] void refuse() {
  throw NoOpenGl(
      "this build of Tripus draws no pictures (TRIPUS_BUILD_VIEWER is OFF); write a page for "
      "a browser with -o page.html");
}

}  // namespace

class OffscreenRenderer::Implementation {};
OffscreenRenderer::OffscreenRenderer() { refuse(); }
OffscreenRenderer::~OffscreenRenderer() = default;
Image OffscreenRenderer::draw(const Scene&, const PictureOptions&, int, int, Pixels) { refuse(); }
Image OffscreenRenderer::draw_inside(const std::shared_ptr<const InsideManifold>&,
                                     const InsideOptions&, const PictureOptions&, int, int,
                                     Pixels) {
  refuse();
}
Image render_inside(const std::shared_ptr<const InsideManifold>&, const InsideOptions&,
                    const PictureOptions&, int, int) {
  refuse();
}
Image render_picture(const Scene&, const PictureOptions&, int, int, Pixels) { refuse(); }
void show_window(const SceneSource&, const WindowOptions&) { refuse(); }

}  // namespace tripus::viewer
