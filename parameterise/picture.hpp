#pragma once

#include <string>

#include "parameterise/vtu.hpp"

namespace tripus::parameterise {

/// Pictures as SVG: triangles from the farthest to the nearest, in parallel projection.
struct SolidPictureOptions {
  double azimuth = 35, elevation = 25;  ///< of the viewer, degrees
  /// Of the solid that is cut away on the viewer's side, by a plane across the line of sight: 0
  /// none, 1 all.
  double cut_away = 0.5;
  int width = 1000, height = 1000;  ///< pixels
};

/// The solid cut open, each tetrahedron in the colour of the manifold's tetrahedron in which its
/// image lies, with darker bands where the distance to the geodesic boundary is an odd multiple of
/// a fifth of the largest.
std::string solid_picture(const ColouredSolid& solid, const SolidPictureOptions& options = {});

/// The same tetrahedra where the map puts them, each in its own frame, in the Klein ball: they fill
/// the fundamental domain. What is turned over is black.
std::string image_picture(const MarkedSolid& solid, const HarmonicMap& map, const Quality& quality,
                          const SolidPictureOptions& options = {});

/// A page for a browser that needs no network: the solid, whole and cut open at kSolidCuts planes,
/// among which a slider chooses.
std::string solid_page(const std::string& title, const ColouredSolid& solid);
inline constexpr int kSolidCuts = 9;

/// A page for a browser that needs no network: numbers, convergence, distortion, the pictures.
std::string report_page(const std::string& title, const MarkedSolid& solid, const HarmonicMap& map,
                        const Quality& quality);

}  // namespace tripus::parameterise
