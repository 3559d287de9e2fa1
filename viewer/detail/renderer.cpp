#include "viewer/detail/renderer.hpp"

#include <algorithm>

#include "viewer/faces/detail/faces_renderer.hpp"
#include "viewer/opencsg/detail/opencsg_renderer.hpp"

namespace tripus::viewer {

Renderer::Renderer() { load_opengl(); }
Renderer::~Renderer() = default;

void Renderer::set_scene(const Scene& scene, Model model) {
  const bool same =
      known_ && model == model_ && scene.discs == scene_.discs &&
      scene.focus.has_value() == scene_.focus.has_value() &&
      std::ranges::equal(scene.cells, scene_.cells, [](const SceneCell& a, const SceneCell& b) {
        return a.tetrahedron == b.tetrahedron && a.depth == b.depth && have_same_walls(a, b) &&
               a.singular_edges == b.singular_edges && a.face_class == b.face_class &&
               a.vertex_class == b.vertex_class && a.edge_class == b.edge_class;
      });
  if (same) return;
  known_ = true;
  scene_ = scene;
  model_ = model;
  ball_ = focus_of(model, scene);
  reach_ = reach_of(model, scene, ball_);
  faces_know_ = opencsg_knows_ = false;
}

std::size_t Renderer::draw(const PictureOptions& options, const Frame& frame) {
  take_scene(options.renderer);
  const View view = view_of(options.camera, ball_, frame.width, frame.height, reach_);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  composer_.begin(frame);
  const std::size_t left = options.renderer == RendererKind::kOpenCsg
                               ? opencsg_->draw(options, frame, view)
                               : faces_->draw(options, frame, view);
  composer_.finish(options, frame, view, ball_);
  glPopAttrib();
  require_no_error();
  return left;
}

void Renderer::take_scene(RendererKind kind) {
  if (kind == RendererKind::kOpenCsg) {
    if (!opencsg_) opencsg_ = std::make_unique<OpenCsgRenderer>();
    if (!opencsg_knows_) opencsg_->set_scene(scene_, model_);
    opencsg_knows_ = true;
    return;
  }
  if (!faces_) faces_ = std::make_unique<FacesRenderer>();
  if (!faces_know_) faces_->set_scene(scene_, model_, ball_.radius);
  faces_know_ = true;
}

}  // namespace tripus::viewer
