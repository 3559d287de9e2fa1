#include "viewer/faces/detail/tubes_renderer.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "embedding/colour.hpp"
#include "viewer/web/detail/assets.hpp"

namespace tripus::viewer {
namespace {

constexpr Colour kIron{0.21F, 0.235F, 0.265F}, kSingular{0.816F, 0.11F, 0.122F};

Colour tube_colour(ColourBy colour_by, const SceneCell& cell, const TubePiece& piece) {
  if (piece.is_singular) return kSingular;
  if (colour_by != ColourBy::kEdge) return kIron;
  Colour colour;
  const auto bytes = embedding::tetrahedron_colour(cell.edge_class.at(piece.edge));
  for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<float>(bytes[k]) / 255;
  return colour;
}

}  // namespace

void TubesRenderer::set_scene(Model model, const Scene& scene, const FaceSet& faces) {
  set_ = TubeSet(model, scene, faces);
  colours_.reset();
}

void TubesRenderer::write_colours(const Scene& scene, ColourBy colour_by) {
  if (colours_ == colour_by) return;
  std::vector<float> numbers = set_.records();
  for (std::size_t i = 0; i < set_.pieces().size(); ++i) {
    const TubePiece& piece = set_.pieces()[i];
    const Colour colour = tube_colour(colour_by, scene.cells[piece.cell], piece);
    const auto end = static_cast<std::ptrdiff_t>(4 * kTubeTexels * (i + 1));
    std::copy(colour.begin(), colour.end(), numbers.begin() + end - 4);
  }
  records_ = number_texture(std::move(numbers));
  colours_ = colour_by;
}

void TubesRenderer::collect(const PictureOptions& options, const Frame& frame, const View& view) {
  struct Seen {
    double distance, margin;
    std::size_t piece;
  };
  std::vector<Seen> seen;
  const Projector projector(view, frame.width * frame.samples, frame.height * frame.samples);
  const bool hidden = is_solid(options) && !options.transparent && !options.cut_away;
  for (std::size_t i = 0; i < set_.pieces().size(); ++i) {
    const TubePiece& piece = set_.pieces()[i];
    if (piece.is_inner && hidden) continue;
    const Vector3 begin = piece.begin.cast<double>(), end = piece.end.cast<double>();
    const BoundingBall ball{(begin + end) / 2, (end - begin).norm() / 2 + piece.margin};
    if (options.cut_away && ball.centre.x() - ball.radius > *options.cut_away) continue;
    const double wide = projector.pixels({ball.centre, piece.radius}) / frame.samples;
    if (wide < kThinnestTube && !piece.is_singular) continue;
    if (projector.pixels(ball) < frame.samples) continue;
    const double more = std::max(0.0, kThinnestTube / wide - 1) * piece.radius;
    seen.push_back({(ball.centre - view.eye).norm(), piece.margin + more, i});
  }
  // The farthest first.
  std::ranges::sort(seen, std::ranges::greater{}, &Seen::distance);
  mesh_.clear();
  for (const Seen& one : seen) {
    const TubePiece& piece = set_.pieces()[one.piece];
    const std::array points{piece.begin, piece.end};
    projector.add(points, one.margin, static_cast<float>(kTubeTexels * one.piece), mesh_);
  }
}

GLuint TubesRenderer::program_of(const PictureOptions& options) {
  const std::size_t model = static_cast<std::size_t>(options.model), cut = options.cut_away ? 1 : 0;
  GlProgram& program = programs_.at(2 * model + cut);
  if (program.name() == 0) {
    using detail::web_asset;
    const std::string defined = "#version 330\n#define kModel " + std::to_string(model) +
                                "\n#define kCut " + std::to_string(cut) + "\n";
    std::string vertex = defined, fragment = defined;
    for (const char* part : {"desktop.glsl", "tubes.vert.glsl"}) vertex += web_asset(part);
    for (const char* part :
         {"desktop.glsl", "tubes.glsl", "desktop_light.glsl", "desktop_tubes.frag.glsl"})
      fragment += web_asset(part);
    program = make_program(vertex, fragment);
  }
  return program.name();
}

void TubesRenderer::draw(const Scene& scene, const PictureOptions& options, const Frame& frame,
                         const View& view) {
  if (!options.lines || !options.tubes) return;
  collect(options, frame, view);
  if (mesh_.triangles.empty()) return;
  write_colours(scene, options.colour_by);
  const Uniform uniform{program_of(options)};
  glUseProgram(uniform.program);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, records_.name());
  glUniform1i(uniform.at("uTubes"), 0);
  glUniform1f(uniform.at("uThin"), static_cast<GLfloat>(kThinnestTube * frame.samples));
  glUniform1f(uniform.at("uCut"), static_cast<GLfloat>(options.cut_away.value_or(0)));
  set_camera(uniform, options, frame, view);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  buffers_.draw(mesh_);
  glDisable(GL_BLEND);
  glUseProgram(0);
}

}  // namespace tripus::viewer
