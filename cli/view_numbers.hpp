#pragma once

#include <array>
#include <string>

#include "geometry/hyperbolic_space.hpp"
#include "viewer/inside/inside_options.hpp"
#include "viewer/picture.hpp"

/// The numbers that options of tripus view take as one text. All throw InvalidInput with the name
/// of the option and what to write.
namespace tripus::cli {

/// --size: width and height in pixels.
std::array<int, 2> parse_size(const std::string& text);

/// --camera; an empty text leaves it as it is.
void parse_camera(const std::string& text, viewer::Camera& camera);

/// --inside: a place, the centre for an empty text, or the tetrahedron and the frame of one who
/// stands in it.
viewer::InsideOptions parse_inside(const std::string& text, const viewer::InsideManifold& m);

/// --moebius: eight numbers, the real and imaginary parts of a, b, c and d; empty: the identity.
geometry::Matrix4 parse_moebius(const std::string& text);

}  // namespace tripus::cli
