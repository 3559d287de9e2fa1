#include "viewer/detail/drawn_discs.hpp"

namespace tripus::viewer {
namespace {

GLfloat number(double x) { return static_cast<GLfloat>(x); }

}  // namespace

void DrawnDiscs::set(std::shared_ptr<const WallDiscs> discs, DiscLight light) {
  if (discs == discs_) return;
  discs_ = std::move(discs);
  if (empty()) return;
  std::vector<GLfloat> texels;
  first_.clear();
  for (const std::vector<WallDisc>& tile : discs_->tiles) {
    first_.push_back(static_cast<GLfloat>(texels.size() / 4));
    for (const WallDisc& disc : tile) {
      for (int k = 0; k < 4; ++k) texels.push_back(number(disc.centre[k]));
      const auto rgb = orthospectrum::length_colour(discs_->scale.share_of(disc.length));
      for (const std::uint8_t part : rgb) {
        const GLfloat shown = number(part / 255.0);
        texels.push_back(light == DiscLight::kLinear ? shown * shown : shown);
      }
      texels.push_back(number(disc.extent));
    }
    texels.insert(texels.end(), {0, 0, 0, 0, 0, 0, 0, -1});  // the end
  }
  const std::size_t row = 4 * static_cast<std::size_t>(kDiscTexelsPerRow);
  rows_ = static_cast<int>((texels.size() + row - 1) / row);
  GLint most_rows = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most_rows);
  if (!GLEW_ARB_texture_float || rows_ > most_rows)
    throw NoOpenGl("this graphics card cannot hold so many discs; try a smaller --discs");
  texels.resize(row * static_cast<std::size_t>(rows_));
  GLuint name = 0;
  glGenTextures(1, &name);
  texture_ = GlTexture(name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F_ARB, kDiscTexelsPerRow, rows_, 0, GL_RGBA, GL_FLOAT,
               texels.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void DrawnDiscs::use_cell(GLuint program, const ToTetrahedron& to_tetrahedron) const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  const Eigen::Matrix<GLfloat, 4, 5> columns = to_tetrahedron.cast<GLfloat>();
  glUniform4fv(glGetUniformLocation(program, "to_tetrahedron"), 5, columns.data());
  glUniform1i(glGetUniformLocation(program, "discs"), 0);
  glUniform1f(glGetUniformLocation(program, "disc_rows"), static_cast<GLfloat>(rows_));
  const orthospectrum::LengthColour bare = kBareWall;
  glUniform3f(glGetUniformLocation(program, "bare"), number(bare[0] / 255.0),
              number(bare[1] / 255.0), number(bare[2] / 255.0));
}

void DrawnDiscs::use_wall(GLuint program, const SceneCell& cell, std::size_t wall) const {
  if (!is_truncation(wall)) return use_none(program);
  glUniform1f(glGetUniformLocation(program, "first_disc"),
              first_texel(cell.tetrahedron, static_cast<std::uint32_t>(wall - 4)));
}

void DrawnDiscs::use_none(GLuint program) {
  glUniform1f(glGetUniformLocation(program, "first_disc"), -1);
}

}  // namespace tripus::viewer
