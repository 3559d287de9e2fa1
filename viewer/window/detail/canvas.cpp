#include "viewer/window/detail/canvas.hpp"

#include <algorithm>

namespace tripus::viewer {

void Canvas::look_from_inside(const std::shared_ptr<const InsideManifold>& manifold,
                              const InsideOptions& inside) {
  if (!inside_renderer_) inside_renderer_ = std::make_unique<InsideRenderer>();
  inside_renderer_->set_manifold(manifold);
  inside_ = inside;
  is_inside_ = true;
}

void Canvas::draw_frame(const PictureOptions& shown, const Frame& frame) {
  if (is_inside_)
    inside_renderer_->draw(shown, inside_, frame);
  else
    renderer_.draw(shown, frame);
}

void Canvas::draw(const PictureOptions& shown, int width, int height, double quality, int samples) {
  // In steps of 8 pixels, so that textures last for some frames.
  const auto coarse = [&](int side) {
    return quality < 1 ? std::clamp(8 * static_cast<int>(quality * side / 8), 8, side) : side;
  };
  Frame frame;
  frame.width = coarse(width);
  frame.height = coarse(height);
  frame.samples = samples;
  if (quality >= 1) {
    draw_frame(shown, frame);
    return;
  }
  if (coarse_.width != frame.width || coarse_.height != frame.height)
    coarse_ = make_render_target(frame.width, frame.height);
  glBindFramebuffer(GL_FRAMEBUFFER, coarse_.framebuffer.name());
  draw_frame(shown, frame);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, coarse_.framebuffer.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, frame.width, frame.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                    GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
}

Image Canvas::identities(const PictureOptions& shown, int width, int height) {
  Frame frame;
  frame.width = std::max(width, 1);
  frame.height = std::max(height, 1);
  frame.identities = true;
  const RenderTarget target = make_render_target(frame.width, frame.height);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
  draw_frame(shown, frame);
  Image image = read_pixels(frame.width, frame.height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return image;
}

}  // namespace tripus::viewer
