#include "viewer/detail/gl.hpp"

#include <algorithm>

namespace tripus::viewer {
namespace {

constexpr const char* kRemedy =
    "; `tripus view INPUT -o page.html` writes a page that a browser shows";

std::string words(const void* text) {
  return text == nullptr ? "unknown" : static_cast<const char*>(text);
}

GLuint compiled(GLenum kind, std::string_view source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::string log(2000, '\0');
  GLsizei written = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  glDeleteShader(shader);
  throw NoOpenGl("OpenGL does not compile our shaders: " + quoted(log, 300) + kRemedy);
}

}  // namespace

void load_opengl() {
  // Without an X server GLEW finds the functions and complains that there is no GLX.
  const GLenum status = glewInit();
  if (status != GLEW_OK && status != GLEW_ERROR_NO_GLX_DISPLAY)
    throw NoOpenGl(
        "the OpenGL functions cannot be looked up: " + words(glewGetErrorString(status)) + kRemedy);
  if (!GLEW_VERSION_2_1 || !GLEW_ARB_framebuffer_object || !GLEW_ARB_occlusion_query)
    throw NoOpenGl(
        "OpenGL 2.1 with framebuffer objects and occlusion queries is needed, and here is " +
        words(glGetString(GL_VERSION)) + kRemedy);
}

GlProgram make_program(std::string_view vertex_source, std::string_view fragment_source) {
  const GLuint vertex = compiled(GL_VERTEX_SHADER, vertex_source);
  GLuint fragment = 0;
  try {
    fragment = compiled(GL_FRAGMENT_SHADER, fragment_source);
  } catch (...) {
    glDeleteShader(vertex);
    throw;
  }
  GlProgram program(glCreateProgram());
  glAttachShader(program.name(), vertex);
  glAttachShader(program.name(), fragment);
  glLinkProgram(program.name());
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint good = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
  if (good != GL_TRUE) throw NoOpenGl(std::string("OpenGL does not link our shaders") + kRemedy);
  return program;
}

RenderTarget make_render_target(int width, int height) {
  const auto texture = [&](GLint inner, GLenum format, GLenum type) {
    GLuint name = 0;
    glGenTextures(1, &name);
    GlTexture owner(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, inner, width, height, 0, format, type, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    return owner;
  };
  RenderTarget target;
  target.width = width;
  target.height = height;
  target.colour = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  target.depth = texture(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  target.framebuffer = GlFramebuffer(name);
  GLint before = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour.name(),
                         0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                         target.depth.name(), 0);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
  if (status != GL_FRAMEBUFFER_COMPLETE)
    throw NoOpenGl("OpenGL refuses to draw pictures of " + std::to_string(width) + "x" +
                   std::to_string(height) + " pixels: ask for a smaller --size");
  return target;
}

Image read_pixels(int width, int height) {
  Image image{width, height, {}};
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  image.pixels.resize(row * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  // OpenGL's rows go up.
  for (std::size_t low = 0, high = static_cast<std::size_t>(height) - 1; low < high; ++low, --high)
    std::swap_ranges(image.pixels.data() + low * row, image.pixels.data() + (low + 1) * row,
                     image.pixels.data() + high * row);
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  return image;
}

}  // namespace tripus::viewer
