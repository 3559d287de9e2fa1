#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "viewer/detail/gl.hpp"
#include "viewer/scene.hpp"

namespace tripus::viewer {

/// Of the texture that holds the discs, two texels each: centre; colour and extent, which is
/// negative behind the last disc of a tile.
inline constexpr int kDiscTexelsPerRow = 2048;

/// How colours of discs are written.
enum class DiscLight : std::uint8_t { kDisplayed, kLinear };

/// The discs of a scene on the graphics card, for discs.glsl and kWallFragmentShader.
class DrawnDiscs {
 public:
  /// Takes the discs of a scene from now on; null: there are none.
  /// Throws NoOpenGl where the card cannot hold them.
  void set(std::shared_ptr<const WallDiscs> discs, DiscLight light = DiscLight::kDisplayed);

  bool empty() const { return discs_ == nullptr; }

  GLuint texture() const { return texture_.name(); }
  /// Where the discs of a tile begin.
  float first_texel(std::uint32_t tetrahedron, std::uint32_t vertex) const {
    return first_[4 * std::size_t{tetrahedron} + vertex];
  }

  /// For OpenCSG: tells the program in use of the cell that is drawn next.
  void use_cell(GLuint program, const ToTetrahedron& to_tetrahedron) const;
  /// Tells it of the wall of that cell: discs lie on truncations alone.
  void use_wall(GLuint program, const SceneCell& cell, std::size_t wall) const;
  /// Tells it that there are none.
  static void use_none(GLuint program);

 private:
  std::shared_ptr<const WallDiscs> discs_;
  std::vector<GLfloat> first_;  // [4 T] texel where the discs of a tile begin
  GlTexture texture_;
  int rows_ = 0;
};

}  // namespace tripus::viewer
