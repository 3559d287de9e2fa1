#include "viewer/egl/offscreen.hpp"

#include <algorithm>

#include "viewer/detail/gl.hpp"
#include "viewer/detail/renderer.hpp"
#include "viewer/inside/detail/inside_renderer.hpp"
#include "viewer/legend.hpp"

// After GLEW.
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace tripus::viewer {
namespace {

/// An OpenGL context without a display or a window, current while it lives.
class OffscreenContext {
 public:
  OffscreenContext() {
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display != nullptr)
      display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
      if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE)
        fail("EGL finds no driver");
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("EGL offers no desktop OpenGL");
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0)
      fail("EGL has no configuration with OpenGL");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT) fail("EGL makes no OpenGL context");
    make_current();
  }
  void make_current() {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      fail("EGL needs a surface where we have none");
  }
  ~OffscreenContext() { close(); }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  [[noreturn]] void fail(const std::string& what) {
    close();
    throw NoOpenGl(
        "no OpenGL here: " + what +
        "; install Mesa's EGL driver (Debian: libegl-mesa0 libgl1-mesa-dri), or write a page "
        "for a browser with -o page.html");
  }
  void close() {
    if (display_ == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
    eglReleaseThread();
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// Samples a pixel, in each direction. The renderer of faces smooths its lines itself.
int samples_for(RendererKind renderer, int width, int height) {
  const double pixels = static_cast<double>(width) * height;
  if (renderer == RendererKind::kOpenCsg && pixels <= 7e5) return 3;
  return pixels <= 4.5e6 ? 2 : 1;
}

}  // namespace

class OffscreenRenderer::Implementation {
 public:
  Image draw(const Scene& scene, const PictureOptions& options, int width, int height,
             Pixels pixels) {
    context_.make_current();
    if (target_.width != width || target_.height != height)
      target_ = make_render_target(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
    renderer_.set_scene(scene, options.model);
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.identities = pixels == Pixels::kIdentities;
    frame.samples = frame.identities      ? 1
                    : options.samples > 0 ? options.samples
                                          : samples_for(options.renderer, width, height);
    const std::size_t left = renderer_.draw(options, frame);
    Image image = read_pixels(width, height);
    if (!frame.identities) {
      add_legend(scene, options, image);
      if (options.labels && left == 0) {
        frame.identities = true;
        frame.samples = 1;
        renderer_.draw(options, frame);
        add_labels(scene, options, read_pixels(width, height), image);
      }
    }
    image.cells_left = left;
    return image;
  }

  Image draw_inside(const std::shared_ptr<const InsideManifold>& manifold,
                    const InsideOptions& inside, const PictureOptions& options, int width,
                    int height, Pixels pixels) {
    context_.make_current();
    if (target_.width != width || target_.height != height)
      target_ = make_render_target(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
    if (!inside_) inside_ = std::make_unique<InsideRenderer>();
    inside_->set_manifold(manifold);
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.identities = pixels == Pixels::kIdentities;
    frame.samples = options.samples > 0 ? options.samples : 3;
    inside_->draw(options, inside, frame);
    return read_pixels(width, height);
  }

 private:
  // The context first: it must outlive what is in it.
  OffscreenContext context_;
  Renderer renderer_;
  std::unique_ptr<InsideRenderer> inside_;
  RenderTarget target_;
};

OffscreenRenderer::OffscreenRenderer() : implementation_(std::make_unique<Implementation>()) {}
OffscreenRenderer::~OffscreenRenderer() = default;

Image OffscreenRenderer::draw(const Scene& scene, const PictureOptions& options, int width,
                              int height, Pixels pixels) {
  require_drawable(scene, options, width, height);
  return implementation_->draw(scene, options, width, height, pixels);
}

Image OffscreenRenderer::draw_inside(const std::shared_ptr<const InsideManifold>& manifold,
                                     const InsideOptions& inside, const PictureOptions& options,
                                     int width, int height, Pixels pixels) {
  require_size(width, height);
  if (!stands_inside(*manifold, inside.walker))
    throw InvalidInput("who looks from inside must stand in a tetrahedron, in front of its walls");
  return implementation_->draw_inside(manifold, inside, options, width, height, pixels);
}

Image render_inside(const std::shared_ptr<const InsideManifold>& manifold,
                    const InsideOptions& inside, const PictureOptions& options, int width,
                    int height) {
  return OffscreenRenderer().draw_inside(manifold, inside, options, width, height);
}

Image render_picture(const Scene& scene, const PictureOptions& options, int width, int height,
                     Pixels pixels) {
  require_drawable(scene, options, width, height);
  return OffscreenRenderer().draw(scene, options, width, height, pixels);
}

}  // namespace tripus::viewer
