#include "viewer/opencsg/detail/cell_product.hpp"

namespace tripus::viewer {
namespace {

/// Whether the wall of a local half-space meets the ball of this radius around the origin.
bool meets(const HalfSpace& local, double radius) {
  // f on the ball lies within |b| r + |a| r^2 of c.
  return std::abs(local.c) <= local.b.norm() * radius + std::abs(local.a) * radius * radius;
}

}  // namespace

DrawnMesh::DrawnMesh(const ConvexMesh& mesh)
    : count_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
  GLuint names[2] = {0, 0};
  glGenBuffers(2, names);
  points_ = GlBuffer(names[0]);
  triangles_ = GlBuffer(names[1]);
  glBindBuffer(GL_ARRAY_BUFFER, names[0]);
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.points.size() * sizeof(mesh.points[0])),
               mesh.points.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])),
               mesh.triangles.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void DrawnMesh::draw() const {
  glBindBuffer(GL_ARRAY_BUFFER, points_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  glDisableClientState(GL_VERTEX_ARRAY);
  // OpenCSG draws from client memory.
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

CellProduct::CellProduct(Model model, const SceneCell& cell)
    : model_(model),
      ball_(bounding_ball(model, cell)),
      to_tetrahedron_(viewer::to_tetrahedron(model, cell, ball_)) {
  for (std::size_t wall = 0; wall < kWallCount; ++wall)
    half_spaces_[wall] = half_space(model, cell, wall);
}

void CellProduct::add_wall(const HalfSpace& in_model, WallKind kind, std::size_t number,
                           double error) {
  const HalfSpace local = in_local_frame(in_model, ball_.centre, ball_.radius);
  if (!meets(local, kPrimitiveReach)) return;
  HalfSpacePrimitive primitive = half_space_primitive(local, error);
  walls_.push_back({local, kind, number, primitive.operation, DrawnMesh(primitive.mesh)});
}

void CellProduct::prepare(double error, const HalfSpace* cut_away) {
  const bool same_cut = cut_away == nullptr ? !cut_ : cut_ && cut_at_.c == cut_away->c;
  constexpr double kFarTooFine = 6;
  if (same_cut && error_ > 0 && error_ <= error && error_ * kFarTooFine >= error) return;
  // Somewhat finer than need be, so that a small step of the camera asks for nothing new.
  error_ = error / 2;
  cut_ = cut_away != nullptr;
  if (cut_) cut_at_ = *cut_away;
  walls_.clear();
  for (std::size_t wall = 0; wall < kWallCount; ++wall)
    add_wall(half_spaces_[wall], is_face(wall) ? WallKind::kFace : WallKind::kTruncation, wall,
             error_);
  // Spheres orthogonal to the model's boundary go on beyond it, and the cell's mirror image lies
  // there; planes of the Klein ball have none. The side is moved out, so that its own mesh cuts off
  // nothing.
  if (model_ != Model::kKleinBall) {
    HalfSpace side = model_side(model_);
    side.c -= error_ * ball_.radius;
    add_wall(side, WallKind::kModelSide, kWallCount, error_);
  }
  if (cut_) add_wall(cut_at_, WallKind::kCutAway, kWallCount, error_);
}

}  // namespace tripus::viewer
