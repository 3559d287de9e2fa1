#include "orthospectrum/boundary_discs.hpp"

#include <algorithm>
#include <cmath>

namespace tripus::orthospectrum {

LengthColour length_colour(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kLengthColours.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(place), kLengthColours.size() - 2);
  const double part = place - static_cast<double>(low);
  LengthColour colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double from = kLengthColours[low][c], to = kLengthColours[low + 1][c];
    colour[c] = static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
  }
  return colour;
}

LengthScale scale_of(const Spectrum& spectrum) {
  const double shortest = spectrum.arcs.empty() ? 0 : spectrum.arcs.front().length;
  return {shortest, std::max(spectrum.length, shortest + 1)};
}

namespace {

/// The inverse of an isometry, exactly.
Matrix3 lorentz_inverse(const Matrix3& isometry) {
  const Vector3 form(1, 1, -1);
  return form.asDiagonal() * isometry.transpose() * form.asDiagonal();
}

}  // namespace

std::vector<std::vector<TileDisc>> discs_by_tile(const BoundarySurface& surface,
                                                 const Spectrum& spectrum) {
  std::vector<std::vector<TileDisc>> discs(surface.tile_count());
  // Arcs come by length, so the discs of each tile do.
  for (const Arc& arc : spectrum.arcs) {
    for (const ArcEnd& end : {arc.start, arc.end}) {
      const Vector3 foot = point_of(end);
      for (const DevelopedTile& met : surface.meeting(end.tile, foot, disc_radius(arc.length)))
        discs[BoundarySurface::index(met.tile)].push_back(
            {lorentz_inverse(met.isometry) * foot, arc.length});
    }
  }
  return discs;
}

}  // namespace tripus::orthospectrum
