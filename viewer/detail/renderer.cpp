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
      std::ranges::equal(scene.cells, scene_.cells, [](const SceneCell& a, const SceneCell& b) {
        return a.tetrahedron == b.tetrahedron && a.depth == b.depth && a.walls == b.walls;
      });
  if (same) return;
  known_ = true;
  scene_ = scene;
  model_ = model;
  ball_ = bounding_ball(model, scene);
  faces_know_ = opencsg_knows_ = false;
}

std::size_t Renderer::draw(const PictureOptions& options, const Frame& frame) {
  if (options.renderer == RendererKind::kOpenCsg) {
    if (!opencsg_) opencsg_ = std::make_unique<OpenCsgRenderer>();
    if (!opencsg_knows_) opencsg_->set_scene(scene_, model_);
    opencsg_knows_ = true;
    return opencsg_->draw(options, frame);
  }
  if (!faces_) faces_ = std::make_unique<FacesRenderer>();
  if (!faces_know_) faces_->set_scene(scene_, model_, ball_);
  faces_know_ = true;
  return faces_->draw(options, frame);
}

}  // namespace tripus::viewer
