#include "viewer/faces/detail/mesh_drawing.hpp"

namespace tripus::viewer {
namespace {

GlBuffer new_buffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return GlBuffer(name);
}

template <class Item>
void fill(GLenum target, const GlBuffer& buffer, const std::vector<Item>& items) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(),
               GL_STREAM_DRAW);
}

/// Of faces.vert.glsl, tubes.vert.glsl and of the places of cells in faces.glsl.
constexpr std::size_t kTexelsPerRow = 2048;

}  // namespace

GlTexture number_texture(std::vector<float> numbers) {
  const std::size_t row = 4 * kTexelsPerRow;
  const std::size_t rows = std::max<std::size_t>(1, (numbers.size() + row - 1) / row);
  GLint most_rows = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most_rows);
  if (rows > static_cast<std::size_t>(most_rows))
    throw NoOpenGl("this graphics card cannot hold so many cells; try fewer --cells");
  numbers.resize(row * rows);
  GLuint name = 0;
  glGenTextures(1, &name);
  GlTexture texture(name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(kTexelsPerRow),
               static_cast<GLsizei>(rows), 0, GL_RGBA, GL_FLOAT, numbers.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

MeshBuffers::MeshBuffers() : corners_(new_buffer()), triangles_(new_buffer()) {}

void MeshBuffers::draw(const ProxyMesh& mesh) const {
  fill(GL_ARRAY_BUFFER, corners_, mesh.corners);
  fill(GL_ELEMENT_ARRAY_BUFFER, triangles_, mesh.triangles);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangles.size()), GL_UNSIGNED_INT,
                 nullptr);
  glDisableVertexAttribArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void set_camera(const Uniform& uniform, const PictureOptions& options, const Frame& frame,
                const View& view) {
  const auto f = [](double x) { return static_cast<GLfloat>(x); };
  const double aspect = static_cast<double>(frame.width) / frame.height;
  const Eigen::Matrix3d rows = view.model_view.topLeftCorner<3, 3>();
  Eigen::Matrix3f axes = rows.transpose().cast<float>();
  axes.col(2) = -axes.col(2);
  const Eigen::Vector3f light = key_light(view).cast<float>();
  const Eigen::Vector3f eye = view.eye.cast<float>();
  glUniform3fv(uniform.at("uEye"), 1, eye.data());
  glUniformMatrix3fv(uniform.at("uAxes"), 1, GL_FALSE, axes.data());
  glUniform2f(uniform.at("uTangent"), f(view.height_at_one * aspect / 2),
              f(view.height_at_one / 2));
  glUniform2f(uniform.at("uShift"), f(options.camera.shift.x() / aspect),
              f(options.camera.shift.y()));
  glUniform2f(uniform.at("uSize"), f(frame.width * frame.samples), f(frame.height * frame.samples));
  glUniform2f(uniform.at("uDepth"), f(view.near), f(view.far));
  glUniform1f(uniform.at("uPixel"), f(view.height_at_one / (frame.height * frame.samples)));
  glUniform3fv(uniform.at("uKeyLight"), 1, light.data());
}

}  // namespace tripus::viewer
