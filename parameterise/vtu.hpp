#pragma once

#include <string>
#include <string_view>

#include "parameterise/harmonic_map.hpp"
#include "parameterise/quality.hpp"

namespace tripus::parameterise {

/// A parameterised solid as VTK's XML file of an unstructured grid, for ParaView, PyVista, meshio
/// and `tripus view --solid`. Arrays, by name:
///   points  point_h3 [4]           on the hyperboloid, time last, in the point's own frame
///           tetrahedron            of the manifold's triangulation, in which the image lies
///           position [3]           there, in the Klein ball, in that tetrahedron's frame
///           distance_to_boundary   to the nearest truncation of that tetrahedron
///   cells   deck [4]               rows of deck_matrices: from the frame of each corner to that of
///                                  the first; f_i in the frame of corner 0 is
///                                  deck_matrices[deck[i]] f_i
///           orientation, volume, anisotropy, volume_ratio   as in CellQuality
///           tetrahedron, distance_to_boundary               of the image of the middle
///           colour [3]             red, green, blue of that tetrahedron
///   fields  deck_matrices [16]     Lorentz matrices, row by row
///           energy, image_volume, manifold_volume           one number each, as in Quality
/// Numbers are doubles in base64.
std::string write_vtu(MarkedSolid& solid, const HarmonicMap& map, const Quality& quality);

/// What of such a file a picture needs.
struct ColouredSolid {
  meshing::TetrahedralMesh mesh = {};
  std::vector<std::uint32_t> tetrahedron = {};    ///< [T] of the manifold
  std::vector<double> distance_to_boundary = {};  ///< [V] of the points
};
/// Throws InvalidInput, naming the array, for a text that is no such file.
ColouredSolid read_coloured_solid(std::string_view vtu);
ColouredSolid coloured(const MarkedSolid& solid, std::span<const Vector4> points);

}  // namespace tripus::parameterise
