#include "viewer/opencsg/detail/opencsg_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "viewer/detail/compose.hpp"
#include "viewer/detail/drawn_discs.hpp"
#include "viewer/detail/gl.hpp"
#include "viewer/opencsg/detail/cell_product.hpp"
#include "viewer/opencsg/detail/shaders.hpp"

namespace tripus::viewer {
namespace {

/// Meshes leave the true walls by less than this, in pixels.
constexpr double kMeshError = 0.2;
/// Cells whose ball is of smaller radius on the picture, in pixels, are not drawn.
constexpr double kSmallestCell = 0.4;
/// Drawing that can be stopped waits for the graphics after so many cells.
constexpr std::size_t kCellsBetweenWaits = 8;

Eigen::Matrix4f as_floats(const Eigen::Matrix4d& matrix) { return matrix.cast<float>(); }

}  // namespace

class OpenCsgRenderer::Implementation {
 public:
  Implementation();
  void set_scene(const Scene& scene, Model model);
  std::size_t draw(const PictureOptions& options, const Frame& frame, const View& view);

 private:
  void draw_cell(std::size_t number, const PictureOptions& options, const Frame& frame,
                 const View& view, const HalfSpace* cut);
  void solve_product(const CellProduct& product, const View& view);
  void shade(std::size_t number, const PictureOptions& options, const Frame& frame,
             const View& view);

  GlProgram wall_program_;
  DrawnMesh bounding_;
  Scene scene_;
  Model model_ = Model::kUpperHalfSpace;
  std::vector<CellProduct> products_;
  DrawnDiscs discs_;
};

OpenCsgRenderer::Implementation::Implementation()
    : wall_program_(make_program(kWallVertexShader, kWallFragmentShader)),
      bounding_(bounding_mesh()) {
  // All primitives are convex: the sequenced subtraction of Stewart, Leach and John. Occlusion
  // queries would save passes, but each waits for the graphics card, and with 8 subtractions that
  // costs more.
  OpenCSG::setOption(OpenCSG::AlgorithmSetting, OpenCSG::SCS);
  OpenCSG::setOption(OpenCSG::DepthComplexitySetting, OpenCSG::NoDepthComplexitySampling);
}

void OpenCsgRenderer::Implementation::set_scene(const Scene& scene, Model model) {
  // Cells that stay keep their meshes.
  const bool grows =
      model == model_ && scene.cells.size() >= scene_.cells.size() &&
      std::equal(scene_.cells.begin(), scene_.cells.end(), scene.cells.begin(),
                 [](const SceneCell& a, const SceneCell& b) { return have_same_walls(a, b); });
  if (!grows) products_.clear();
  scene_ = scene;
  model_ = model;
  discs_.set(scene.discs);
  products_.reserve(scene.cells.size());
  while (products_.size() < scene.cells.size())
    products_.emplace_back(model, scene.cells[products_.size()]);
}

std::size_t OpenCsgRenderer::Implementation::draw(const PictureOptions& options, const Frame& frame,
                                                  const View& view) {
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(as_floats(view.projection).data());
  glMatrixMode(GL_MODELVIEW);
  HalfSpace cut{0, {1, 0, 0}, 0};
  if (options.cut_away) cut.c = -*options.cut_away;
  // What is hidden then fails the depth test early.
  std::vector<BoundingBall> balls;
  for (const CellProduct& product : products_) balls.push_back(product.ball());
  const std::vector<std::size_t> order = nearest_first(balls, view.eye);
  for (std::size_t i = 0; i < order.size(); ++i) {
    // Else the queue of drawing commands, seconds long, would have to be waited for.
    if (options.stop.possible() && i % kCellsBetweenWaits == 0) glFinish();
    if (is_stopped(options)) return order.size() - i;
    draw_cell(order[i], options, frame, view, options.cut_away ? &cut : nullptr);
  }
  return 0;
}

void OpenCsgRenderer::Implementation::draw_cell(std::size_t number, const PictureOptions& options,
                                                const Frame& frame, const View& view,
                                                const HalfSpace* cut) {
  CellProduct& product = products_[number];
  const double distance = (product.centre() - view.eye).norm();
  const double pixels =
      product.scale() / distance * frame.height * frame.samples / view.height_at_one;
  if (pixels < kSmallestCell * frame.samples) return;
  if (cut != nullptr) {
    const double beyond = (*cut)(product.centre());
    if (beyond > product.scale()) return;
    if (beyond < -product.scale()) cut = nullptr;
  }
  product.prepare(kMeshError * frame.samples / pixels, cut);

  Eigen::Matrix4d place = Eigen::Matrix4d::Identity();
  place.topLeftCorner<3, 3>() *= product.scale();
  place.topRightCorner<3, 1>() = product.centre();
  glLoadMatrixf(as_floats(view.model_view * place).data());
  if (is_solid(options)) solve_product(product, view);
  shade(number, options, frame, view);
}

void OpenCsgRenderer::Implementation::solve_product(const CellProduct& product, const View& view) {
  // The box of the picture where the cell is.
  const Eigen::Vector3d centre = (view.model_view * product.centre().homogeneous()).head(3);
  const double reach = kPrimitiveReach * product.scale();
  Eigen::Array3f low = Eigen::Array3f::Constant(1), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p =
        centre +
        reach * Eigen::Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Eigen::Vector4d clip = view.projection * p.homogeneous();
    const Eigen::Array3f ndc = (clip.head<3>() / clip[3]).cast<float>().array();
    low = low.min(ndc);
    high = high.max(ndc);
  }
  low = low.max(-1);
  high = high.min(1);
  if ((low >= high).any()) return;

  std::vector<MeshPrimitive> primitives;
  primitives.reserve(product.walls().size() + 1);
  primitives.emplace_back(Operation::kIntersect, bounding_);
  for (const CellProduct::Wall& wall : product.walls())
    primitives.emplace_back(wall.operation, wall.mesh);
  std::vector<OpenCSG::Primitive*> pointers;
  for (MeshPrimitive& primitive : primitives) {
    primitive.setBoundingBox(low[0], low[1], low[2], high[0], high[1], high[2]);
    pointers.push_back(&primitive);
  }
  OpenCSG::render(pointers);
}

void OpenCsgRenderer::Implementation::shade(std::size_t number, const PictureOptions& options,
                                            const Frame& frame, const View& view) {
  const CellProduct& product = products_[number];
  const SceneCell& cell = scene_.cells[number];
  const std::vector<CellProduct::Wall>& walls = product.walls();
  std::array<GLfloat, 4 * kMostHalfSpaces> linear{};
  std::array<GLfloat, kMostHalfSpaces> square{}, kind{};
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      linear[4 * i + static_cast<std::size_t>(k)] = static_cast<GLfloat>(walls[i].local.b[k]);
    linear[4 * i + 3] = static_cast<GLfloat>(walls[i].local.c);
    square[i] = static_cast<GLfloat>(walls[i].local.a);
    kind[i] = static_cast<GLfloat>(walls[i].kind);
  }
  const Eigen::Vector3f eye = ((view.eye - product.centre()) / product.scale()).cast<float>();
  const Eigen::Vector3f light = key_light(view).cast<float>();
  glUseProgram(wall_program_.name());
  const Uniform uniform{wall_program_.name()};
  glUniform4fv(uniform.at("linear"), kMostHalfSpaces, linear.data());
  glUniform1fv(uniform.at("square"), kMostHalfSpaces, square.data());
  glUniform1fv(uniform.at("kind"), kMostHalfSpaces, kind.data());
  glUniform1i(uniform.at("count"), static_cast<GLint>(walls.size()));
  const bool discarding = !is_solid(options);
  glUniform1i(uniform.at("discarding"), discarding ? 1 : 0);
  glUniform1i(uniform.at("plain"), frame.identities ? 1 : 0);
  glUniform3fv(uniform.at("eye"), 1, eye.data());
  glUniform3fv(uniform.at("key_light"), 1, light.data());
  const double pixels = product.scale() / (product.centre() - view.eye).norm() * frame.height *
                        frame.samples / view.height_at_one;
  glUniform1f(uniform.at("slack"), static_cast<GLfloat>(2 * product.mesh_error()));
  glUniform1f(uniform.at("pixel"), static_cast<GLfloat>(1 / pixels));
  // Small cells have thin edges, or they would be nothing but edges.
  const double widest = 1.5 * frame.samples * std::max(1.0, frame.height / 900.0);
  glUniform1f(uniform.at("line_width"), static_cast<GLfloat>(std::min(widest, 0.03 * pixels)));

  const bool with_discs = options.discs && !discs_.empty();
  if (with_discs)
    discs_.use_cell(uniform.program, product.to_tetrahedron());
  else
    DrawnDiscs::use_none(uniform.program);

  glDepthFunc(discarding ? GL_LESS : GL_EQUAL);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const CellProduct::Wall& wall = walls[i];
    if (wall.kind == WallKind::kFace && !options.faces) continue;
    if (wall.kind == WallKind::kTruncation && !options.truncations) continue;
    if (discarding && (wall.kind == WallKind::kModelSide || wall.kind == WallKind::kCutAway))
      continue;
    Colour colour = wall.number < kWallCount ? wall_colour(options.colour_by, cell, wall.number)
                                             : wall_colour(options.colour_by, cell, 4);
    if (frame.identities) {
      const auto id = static_cast<std::uint32_t>(number + 1);
      colour = {static_cast<float>(id & 255U) / 255, static_cast<float>(id >> 8U) / 255,
                static_cast<float>(wall.number + 1) / 255};
    }
    glUniform3fv(uniform.at("colour"), 1, colour.data());
    glUniform1i(uniform.at("own"), static_cast<GLint>(i));
    if (with_discs) discs_.use_wall(uniform.program, cell, wall.number);
    if (discarding) {
      glDisable(GL_CULL_FACE);
    } else {
      glEnable(GL_CULL_FACE);
      glCullFace(wall.operation == Operation::kIntersect ? GL_BACK : GL_FRONT);
    }
    wall.mesh.draw();
  }
  glDisable(GL_CULL_FACE);
  glDepthFunc(GL_LESS);
  glUseProgram(0);
}

OpenCsgRenderer::OpenCsgRenderer() : implementation_(std::make_unique<Implementation>()) {}
OpenCsgRenderer::~OpenCsgRenderer() { OpenCSG::freeResources(); }
void OpenCsgRenderer::set_scene(const Scene& scene, Model model) {
  implementation_->set_scene(scene, model);
}
std::size_t OpenCsgRenderer::draw(const PictureOptions& options, const Frame& frame,
                                  const View& view) {
  return implementation_->draw(options, frame, view);
}

}  // namespace tripus::viewer
