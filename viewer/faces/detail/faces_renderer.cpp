#include "viewer/faces/detail/faces_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "embedding/colour.hpp"
#include "viewer/web/detail/assets.hpp"

namespace tripus::viewer {
namespace {

/// Cells whose ball is of smaller radius on the picture, in pixels, are not drawn.
constexpr double kSmallestCell = 0.4;
/// Polygons around smaller faces, in pixels, are squares around their balls.
constexpr double kSmallFace = 1;
/// Drawing that can be stopped waits for the graphics after so many cells.
constexpr std::size_t kCellsBetweenWaits = 2000;
/// The alpha of transparent walls.
constexpr double kClear = 0.22;

/// The half-spaces of a cell's walls with these numbers.
std::vector<HalfSpace> half_spaces_of(const FaceSet& set, std::size_t cell,
                                      const std::vector<std::size_t>& walls) {
  std::vector<HalfSpace> result;
  for (const std::size_t wall : walls)
    result.push_back(set.half_spaces()[set.walls_per_cell() * cell + wall]);
  return result;
}

/// The colours of edge classes, three numbers each.
std::vector<float> palette_numbers() {
  std::vector<float> numbers;
  for (std::uint32_t i = 0; i < embedding::kColourCount; ++i)
    for (const auto byte : embedding::tetrahedron_colour(i))
      numbers.push_back(static_cast<float>(byte) / 255);
  return numbers;
}

}  // namespace

FacesRenderer::FacesRenderer() {
  if (!GLEW_VERSION_3_3) {
    throw NoOpenGl(
        "the renderer faces needs OpenGL 3.3; --renderer opencsg does with 2.1, and `tripus view "
        "INPUT -o page.html` writes a page that a browser shows");
  }
}

void FacesRenderer::set_scene(const Scene& scene, Model model, double scene_radius) {
  scene_ = scene;
  set_ = FaceSet(model, scene, scene_radius);
  tubes_.set_scene(model, scene_, set_);
  discs_.set(scene.discs);
  colours_.reset();
  places_written_ = false;
}

void FacesRenderer::write_records(const PictureOptions& options) {
  const bool same_colours = colours_ == options.colour_by;
  if (same_colours && cut_ == options.cut_away) return;
  if (!same_colours) {
    texels_.clear();
    first_texel_.clear();
    std::array<std::vector<std::size_t>, kWallCount> bounds;
    for (std::size_t wall = 0; wall < kWallCount; ++wall)
      bounds[wall] = bounds_of_wall(wall, set_.has_edge_walls());
    for (std::size_t i = 0; i < set_.faces().size(); ++i) {
      const SceneFace& face = set_.faces()[i];
      const SceneCell& cell = scene_.cells[face.cell];
      first_texel_.push_back(static_cast<float>(texels_.size() / 4));
      if (face.point_count == 0) continue;
      FaceLook look{face.cell, face.wall, face.is_shared(), -1,
                    wall_colour(options.colour_by, cell, face.wall)};
      if (is_face(face.wall)) look.edge_colours = edge_colours(cell, face.wall);
      if (!discs_.empty() && is_truncation(face.wall))
        look.first_disc = discs_.first_texel(cell.tetrahedron, face.wall - 4U);
      append_record(texels_, set_.cell_balls()[face.cell], set_.half_spaces()[i],
                    half_spaces_of(set_, face.cell, bounds[face.wall]), look, set_.is_bent());
    }
    fixed_texels_ = texels_.size();
  }
  texels_.resize(fixed_texels_);
  colours_ = options.colour_by;
  cut_ = options.cut_away;
  write_cuts();
  records_ = number_texture(texels_);
}

void FacesRenderer::write_cuts() {
  cuts_.clear();
  if (!cut_) return;
  const HalfSpace cut{0, {1, 0, 0}, -*cut_};
  const std::vector<std::size_t> all = bounds_of_wall(kWallCount, set_.has_edge_walls());
  cuts_.resize(scene_.cells.size());
  for (std::size_t cell = 0; cell < scene_.cells.size(); ++cell) {
    const BoundingBall& ball = set_.cell_balls()[cell];
    const double beyond = cut(ball.centre);
    if (std::abs(beyond) >= ball.radius) continue;
    cuts_[cell] = {
        static_cast<float>(texels_.size() / 4),
        {ball.centre - beyond * cut.b, std::sqrt(ball.radius * ball.radius - beyond * beyond)}};
    append_record(texels_, ball, cut, half_spaces_of(set_, cell, all),
                  {static_cast<std::uint32_t>(cell), static_cast<std::uint8_t>(kWallCount), false,
                   -1, wall_colour(*colours_, scene_.cells[cell], 4)},
                  set_.is_bent());
  }
}

void FacesRenderer::write_places() {
  std::vector<float> numbers;
  for (std::size_t cell = 0; cell < scene_.cells.size(); ++cell) {
    const ToTetrahedron columns =
        to_tetrahedron(set_.model(), scene_.cells[cell], set_.cell_balls()[cell]);
    for (Eigen::Index i = 0; i < columns.size(); ++i)
      numbers.push_back(static_cast<float>(columns.data()[i]));
  }
  places_ = number_texture(std::move(numbers));
  places_written_ = true;
}

std::size_t FacesRenderer::draw(const PictureOptions& options, const Frame& frame,
                                const View& view) {
  write_records(options);
  if (options.discs && !discs_.empty() && !places_written_) write_places();
  const Projector projector(view, frame.width * frame.samples, frame.height * frame.samples);
  // So that a stop leaves the best ones.
  const std::vector<std::size_t> order = nearest_first(set_.cell_balls(), view.eye);
  const auto is_clear = [&](std::size_t cell) { return is_transparent(options, cell); };
  for (std::size_t done = 0; done < order.size();) {
    if (options.stop.possible() && done > 0) glFinish();
    if (is_stopped(options)) return order.size() - done;
    const std::size_t end = std::min(done + kCellsBetweenWaits, order.size());
    for (; done < end; ++done)
      if (!is_clear(order[done])) add_cell(order[done], options, view, projector, frame.samples);
    draw_meshes(options, frame, view, 1);
  }
  if (frame.identities) return 0;
  tubes_.draw(scene_, options, frame, view);
  if (!options.transparent || !is_solid(options)) return 0;
  // What one looks through comes last, the farthest first, and hides nothing.
  for (std::size_t i = order.size(); i-- > 0;)
    if (is_clear(order[i])) add_cell(order[i], options, view, projector, frame.samples);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  draw_meshes(options, frame, view, kClear);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  return 0;
}

bool FacesRenderer::is_transparent(const PictureOptions& options, std::size_t cell) const {
  return options.transparent && scene_.cells[cell].tetrahedron == *options.transparent;
}

void FacesRenderer::add_cell(std::size_t cell, const PictureOptions& options, const View& view,
                             const Projector& projector, int samples) {
  const BoundingBall& cell_ball = set_.cell_balls()[cell];
  const double cell_pixels = projector.pixels(cell_ball);
  if (cell_pixels < kSmallestCell * samples) return;
  if (cut_ && cell_ball.centre.x() - *cut_ > cell_ball.radius) return;
  const bool solid = is_solid(options);
  const std::size_t walls = set_.walls_per_cell();
  for (std::size_t i = walls * cell; i < walls * (cell + 1); ++i) {
    const SceneFace& face = set_.faces()[i];
    if (face.point_count == 0) continue;
    if (is_face(face.wall) ? !options.faces : !options.truncations) continue;
    // Through a transparent partner it is seen.
    if (solid && face.is_shared() &&
        (is_transparent(options, cell) || !is_transparent(options, face.partner)))
      continue;
    const std::span points(set_.points().data() + face.first_point, face.point_count);
    if (solid && !may_face(set_.half_spaces()[i], points, face.margin, view.eye)) continue;
    ProxyMesh& mesh = kinds_[static_cast<std::size_t>(record_kind(face.wall))].mesh;
    // Where cells are small, so are their faces.
    if (cell_pixels < kSmallFace * samples || projector.pixels(face.ball) < kSmallFace)
      projector.add(face.ball, first_texel_[i], mesh);
    else
      projector.add(points, face.margin, first_texel_[i], mesh);
  }
  if (solid && cut_ && cuts_[cell].first_texel >= 0)
    projector.add(cuts_[cell].ball, cuts_[cell].first_texel,
                  kinds_[static_cast<std::size_t>(RecordKind::kCut)].mesh);
}

GLuint FacesRenderer::program_of(RecordKind kind, const PictureOptions& options) {
  const std::size_t bounds = bound_count(kind, set_.has_edge_walls());
  std::string defined = "#version 330\n";
  const auto define = [&](const char* name, std::size_t value) {
    defined += std::string("#define ") + name + " " + std::to_string(value) + "\n";
  };
  define("kKind", static_cast<std::size_t>(kind));
  define("kBounds", bounds);
  define("kBends", set_.is_bent() ? bends_of_record(kind, bounds) : 0);
  define("kSides", is_solid(options) ? 1 : 2);
  define("kModel", static_cast<std::size_t>(options.model));
  define("kCut", options.cut_away && kind != RecordKind::kCut ? 1 : 0);
  define("kEdges", options.colour_by == ColourBy::kEdge && options.lines ? 1 : 0);
  define("kDiscs", kind == RecordKind::kTruncation && options.discs && !discs_.empty() ? 1 : 0);
  GlProgram& program = kinds_[static_cast<std::size_t>(kind)].programs[defined];
  if (program.name() == 0) {
    using detail::web_asset;
    std::string vertex = defined, fragment = defined;
    for (const char* part : {"desktop.glsl", "faces.vert.glsl"}) vertex += web_asset(part);
    for (const char* part :
         {"desktop.glsl", "discs.glsl", "faces.glsl", "desktop_light.glsl", "desktop.frag.glsl"})
      fragment += web_asset(part);
    program = make_program(vertex, fragment);
  }
  return program.name();
}

void FacesRenderer::draw_meshes(const PictureOptions& options, const Frame& frame, const View& view,
                                double alpha) {
  const auto f = [](double x) { return static_cast<GLfloat>(x); };
  const auto bind = [](int unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.name());
  };
  bind(0, records_);
  bind(2, places_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, discs_.texture());
  glActiveTexture(GL_TEXTURE0);
  const double widest =
      !options.lines ? -1e3 : 1.5 * frame.samples * std::max(1.0, frame.height / 900.0);
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    Kind& kind = kinds_[i];
    if (kind.mesh.triangles.empty()) continue;
    const Uniform uniform{program_of(static_cast<RecordKind>(i), options)};
    glUseProgram(uniform.program);
    glUniform1i(uniform.at("uFaces"), 0);
    glUniform1i(uniform.at("uDiscs"), 1);
    glUniform1i(uniform.at("uPlaces"), 2);
    const orthospectrum::LengthColour bare = kBareWall;
    glUniform3f(uniform.at("uBareWall"), f(bare[0] / 255.0), f(bare[1] / 255.0),
                f(bare[2] / 255.0));
    set_camera(uniform, options, frame, view);
    glUniform1f(uniform.at("uShrink"), 1);
    glUniform1f(uniform.at("uCut"), f(options.cut_away.value_or(0)));
    glUniform2f(uniform.at("uLine"), f(widest), f(widest / 2));
    glUniform1f(uniform.at("uAlpha"), f(alpha));
    if (options.colour_by == ColourBy::kEdge)
      glUniform3fv(uniform.at("uPalette"), embedding::kColourCount, palette_numbers().data());
    glUniform1i(uniform.at("uIdentities"), frame.identities ? 1 : 0);
    buffers_.draw(kind.mesh);
    kind.mesh.clear();
  }
  glUseProgram(0);
}

}  // namespace tripus::viewer
