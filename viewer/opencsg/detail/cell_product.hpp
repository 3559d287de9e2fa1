#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <opencsg.h>

#include "viewer/detail/gl.hpp"
#include "viewer/opencsg/half_space_mesh.hpp"
#include "viewer/scene.hpp"

namespace tripus::viewer {

/// A mesh on the graphics card.
class DrawnMesh {
 public:
  explicit DrawnMesh(const ConvexMesh& mesh);
  void draw() const;

 private:
  GlBuffer points_;
  GlBuffer triangles_;
  GLsizei count_ = 0;
};

/// A closed convex mesh as OpenCSG wants it. The mesh must outlive it.
class MeshPrimitive : public OpenCSG::Primitive {
 public:
  MeshPrimitive(Operation operation, const DrawnMesh& mesh)
      : OpenCSG::Primitive(
            operation == Operation::kIntersect ? OpenCSG::Intersection : OpenCSG::Subtraction, 1),
        mesh_(&mesh) {}
  void render() override { mesh_->draw(); }

 private:
  const DrawnMesh* mesh_;
};

/// What a half-space of a product is; the numbers are those of the shader.
enum class WallKind { kFace = 0, kTruncation = 1, kModelSide = 2, kCutAway = 3 };

/// One cell as a CSG product in its own frame: p = centre + scale q, the cell within |q| <= 1.
class CellProduct {
 public:
  struct Wall {
    HalfSpace local;
    WallKind kind = WallKind::kFace;
    std::size_t number = 0;  ///< of the cell's wall, kWallCount for the others
    Operation operation = Operation::kIntersect;
    DrawnMesh mesh;
  };

  CellProduct(Model model, const SceneCell& cell);

  const BoundingBall& ball() const { return ball_; }
  const Vector3& centre() const { return ball_.centre; }
  double scale() const { return ball_.radius; }
  const ToTetrahedron& to_tetrahedron() const { return to_tetrahedron_; }

  /// Makes the meshes so fine that they leave the walls by less than `error` (local), unless they
  /// are already, and not far too fine. `cut_away`: the cut, or null.
  void prepare(double error, const HalfSpace* cut_away);

  /// What the meshes leave their walls by at most (local).
  double mesh_error() const { return error_; }
  const std::vector<Wall>& walls() const { return walls_; }

 private:
  void add_wall(const HalfSpace& in_model, WallKind kind, std::size_t number, double error);

  Model model_;
  std::array<HalfSpace, kWallCount> half_spaces_;
  BoundingBall ball_;
  ToTetrahedron to_tetrahedron_;
  double error_ = 0;  ///< of the meshes that there are
  bool cut_ = false;
  HalfSpace cut_at_;
  std::vector<Wall> walls_;
};

}  // namespace tripus::viewer
