#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "viewer/faces/face_set.hpp"

namespace tripus::viewer {

/// Hyperbolic radius of the tubes around edges, and of those around singular ones.
inline constexpr double kTubeRadius = 0.025, kSingularTubeRadius = 0.05;
/// Thinner tubes, in pixels, are left to the lines of faces, which are no wider. Singular edges are
/// not: their tubes are made so wide.
inline constexpr double kThinnestTube = 1.5;

/// A piece of the tube around an edge, short enough to be nearly straight in the model.
struct TubePiece {
  std::uint32_t cell = 0;
  std::uint8_t edge = 0;  ///< 0..5
  bool is_singular = false;
  /// Whether cells of the scene surround the edge: where they are solid it is never seen.
  bool is_inner = false;
  Eigen::Vector3f begin, end;  ///< of its axis, in the model
  float radius = 0;            ///< of the tube there, at its widest, in the model
  float margin = 0;            ///< the piece lies within this of its axis' chord
};

/// The tubes around all edges of a scene, each edge once, though many cells have it.
class TubeSet {
 public:
  TubeSet() = default;
  ///   faces  of the same scene and model
  TubeSet(Model model, const Scene& scene, const FaceSet& faces);

  const std::vector<TubePiece>& pieces() const { return pieces_; }
  /// [4 kTubeTexels x pieces] numbers that tubes.vert.glsl reads, but for the colours.
  const std::vector<float>& records() const { return records_; }

 private:
  struct Edge {
    Vector4 begin, end;  ///< on the hyperboloid
    Vector3 middle;      ///< in the model
    std::uint32_t cell = 0;
    std::uint8_t number = 0;
    bool is_inner = false;
  };
  std::vector<Edge> find_edges(const Scene& scene, const FaceSet& faces) const;
  void add_edge(const Scene& scene, const Edge& edge);
  void add_piece(const SceneCell& cell, const Edge& edge, const Vector4& begin, const Vector4& end);

  Model model_ = Model::kUpperHalfSpace;
  std::vector<TubePiece> pieces_;
  std::vector<float> records_;
};

/// Texels of four numbers in the record of a piece.
inline constexpr std::size_t kTubeTexels = 9;

}  // namespace tripus::viewer
