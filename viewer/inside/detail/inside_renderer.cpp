#include "viewer/inside/detail/inside_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "embedding/colour.hpp"
#include "viewer/faces/detail/mesh_drawing.hpp"
#include "viewer/web/detail/assets.hpp"

namespace tripus::viewer {
namespace {

constexpr int kMostCrossings = 60;

/// Linear light of a colour, as common.glsl's toDisplay takes it.
GLfloat linear_part(int byte) {
  const float part = static_cast<float>(byte) / 255;
  return part * part;
}

using Rgb = std::array<int, 3>;
// As in pages (web/panel.js, web/palette.js).
constexpr Rgb kLightFog{0xdf, 0xe7, 0xee}, kDarkFog{0x0b, 0x14, 0x20}, kSingular{0xd0, 0x1c, 0x1f};

void set_colour(const Uniform& uniform, const char* name, const Rgb& rgb) {
  glUniform3f(uniform.at(name), linear_part(rgb[0]), linear_part(rgb[1]), linear_part(rgb[2]));
}

/// A shader of pages as OpenGL 3.3 has it: common.glsl begins with the version of pages.
std::string common_part() {
  const std::string_view text = detail::web_asset("common.glsl");
  return "#version 330\n" + std::string(text.substr(text.find('\n') + 1)) + "\n";
}

/// Tangents of half the angles of view; a wide picture would stretch its sides.
std::array<double, 2> tangents(double aspect) {
  constexpr double kNarrow = 0.72, kWidest = 1.25;
  const double across = aspect >= 1 ? kNarrow * aspect : kNarrow;
  const double up = aspect >= 1 ? kNarrow : kNarrow / aspect;
  const double shrink = std::min(1.0, kWidest / std::max(across, up));
  return {across * shrink, up * shrink};
}

}  // namespace

InsideRenderer::InsideRenderer() {
  load_opengl();
  if (!GLEW_VERSION_3_3) {
    throw NoOpenGl(
        "the view from inside needs OpenGL 3.3; `tripus view INPUT -o page.html` writes a page "
        "that a "
        "browser shows");
  }
}

void InsideRenderer::set_manifold(std::shared_ptr<const InsideManifold> manifold) {
  if (manifold == manifold_) return;
  manifold_ = std::move(manifold);
  const int kinds = manifold_->kinds();
  if (program_.name() == 0 || kinds != kinds_) {
    using detail::web_asset;
    const std::string common = common_part();
    std::string fragment = common + "#define kKinds " + std::to_string(kinds) + "\n";
    fragment += web_asset("discs.glsl");
    fragment += web_asset("inside.frag.glsl");
    program_ = make_program(common + std::string(web_asset("fullscreen.vert.glsl")), fragment);
    kinds_ = kinds;
  }
  discs_.set(manifold_->discs, DiscLight::kLinear);
  std::vector<float> first_disc;
  if (!discs_.empty()) {
    for (std::uint32_t t = 0; t < manifold_->tetrahedra.size(); ++t)
      for (std::uint32_t v = 0; v < 4; ++v) first_disc.push_back(discs_.first_texel(t, v));
  }
  records_ = number_texture(inside_records(*manifold_, first_disc));
}

void InsideRenderer::draw(const PictureOptions& options, const InsideOptions& inside,
                          const Frame& frame) {
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DITHER);
  glDisable(GL_BLEND);
  if (frame.samples == 1 || frame.identities) {
    draw_sample(options, inside, frame, 0, 0);
  } else {
    GLint picture = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &picture);
    if (sum_width_ != frame.width || sum_height_ != frame.height) {
      GLuint name = 0;
      glGenTextures(1, &name);
      sum_ = GlTexture(name);
      glBindTexture(GL_TEXTURE_2D, name);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, frame.width, frame.height, 0, GL_RGBA, GL_FLOAT,
                   nullptr);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glGenFramebuffers(1, &name);
      sum_buffer_ = GlFramebuffer(name);
      glBindFramebuffer(GL_FRAMEBUFFER, name);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sum_.name(), 0);
      sum_width_ = frame.width;
      sum_height_ = frame.height;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, sum_buffer_.name());
    glEnable(GL_BLEND);
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    const int n = frame.samples;
    for (int i = 0; i < n * n; ++i) {
      glBlendColor(0, 0, 0, 1 / static_cast<GLfloat>(i + 1));
      draw_sample(options, inside, frame, (i % n + 0.5) / n - 0.5, (i / n + 0.5) / n - 0.5);
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(picture));
    glBlitFramebuffer(0, 0, frame.width, frame.height, 0, 0, frame.width, frame.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(picture));
  }
  glPopAttrib();
  require_no_error();
}

void InsideRenderer::draw_sample(const PictureOptions& options, const InsideOptions& inside,
                                 const Frame& frame, double jitter_x, double jitter_y) const {
  const auto f = [](double x) { return static_cast<GLfloat>(x); };
  const Uniform uniform{program_.name()};
  glViewport(0, 0, frame.width, frame.height);
  glUseProgram(uniform.program);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, discs_.texture());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, records_.name());
  glUniform1i(uniform.at("uTetrahedra"), 0);
  glUniform1i(uniform.at("uDiscs"), 1);
  glUniform1i(uniform.at("uDiscsOn"), options.discs && !discs_.empty() ? 1 : 0);
  set_colour(uniform, "uBareWall", {kBareWall[0], kBareWall[1], kBareWall[2]});
  glUniform1i(uniform.at("uPerRow"), static_cast<GLint>(kInsidePerRow));
  glUniform1i(uniform.at("uStart"), static_cast<GLint>(inside.walker.tetrahedron));
  const Eigen::Matrix4f stands = inside.walker.frame.cast<float>();
  glUniformMatrix4fv(uniform.at("uFrame"), 1, GL_FALSE, stands.data());
  const auto [across, up] = tangents(static_cast<double>(frame.width) / frame.height);
  glUniform2f(uniform.at("uTangent"), f(across), f(up));
  glUniform2f(uniform.at("uSize"), f(frame.width), f(frame.height));
  glUniform2f(uniform.at("uJitter"), f(jitter_x), f(jitter_y));
  glUniform1f(uniform.at("uPixel"), f(2 * up / frame.height));
  glUniform1i(uniform.at("uMaxCrossings"), kMostCrossings);
  glUniform1f(uniform.at("uTube"), f(std::pow(std::sinh(inside.tube), 2)));
  glUniform1f(uniform.at("uFog"), f(1 / inside.sight));
  glUniform1f(uniform.at("uMirror"), 0);
  glUniform1i(uniform.at("uGrid"), options.lines ? 1 : 0);
  glUniform1i(uniform.at("uColourBy"), options.colour_by == ColourBy::kComponent ? 1 : 0);
  std::vector<GLfloat> palette;
  for (std::uint32_t i = 0; i < embedding::kColourCount; ++i)
    for (const auto byte : embedding::tetrahedron_colour(i)) palette.push_back(linear_part(byte));
  glUniform3fv(uniform.at("uPalette"), embedding::kColourCount, palette.data());
  set_colour(uniform, "uFogColour", options.dark ? kDarkFog : kLightFog);
  set_colour(uniform, "uSingular", kSingular);
  glUniform1i(uniform.at("uOutput"), frame.identities ? 1 : 0);
  glBegin(GL_TRIANGLES);  // three vertices, which the shader places by their numbers
  for (int i = 0; i < 3; ++i) glVertex2f(0, 0);
  glEnd();
  glUseProgram(0);
}

}  // namespace tripus::viewer
