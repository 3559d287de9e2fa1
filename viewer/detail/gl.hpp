#pragma once

// GLEW comes before every other OpenGL header.
#include <string>
#include <string_view>
#include <utility>

#include <GL/glew.h>

#include "viewer/picture.hpp"

namespace tripus::viewer {

/// Looks the OpenGL functions up for the current context.
/// Throws NoOpenGl if the context cannot do what the renderer needs.
void load_opengl();

/// An OpenGL object's name, deleted with the owner; its context must be current then.
template <void (*Delete)(GLuint)>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) Delete(name_);
  }
  GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

inline void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void delete_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void delete_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void delete_program(GLuint name) { glDeleteProgram(name); }
using GlBuffer = GlObject<delete_buffer>;
using GlTexture = GlObject<delete_texture>;
using GlFramebuffer = GlObject<delete_framebuffer>;
using GlProgram = GlObject<delete_program>;

/// Compiles and links. Throws NoOpenGl with the driver's words.
GlProgram make_program(std::string_view vertex_source, std::string_view fragment_source);

/// A colour and a depth texture of one size to draw into, with a stencil buffer.
struct RenderTarget {
  int width = 0;
  int height = 0;
  GlTexture colour;
  GlTexture depth;
  GlFramebuffer framebuffer;
};

/// Throws NoOpenGl if the driver refuses the size.
RenderTarget make_render_target(int width, int height);

/// The pixels of the bound framebuffer, alpha 255.
Image read_pixels(int width, int height);

}  // namespace tripus::viewer
