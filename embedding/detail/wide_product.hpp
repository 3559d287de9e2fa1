#pragma once

#include <span>

#include "geometry/moebius.hpp"

/// Products of many Moebius maps. In doubles what is far from the identity on the way leaves an
/// error of the square of its size in the product, however near that is: after a way of thirty
/// letters out and back the matrix of an identity is off the group by more than 1.
namespace tripus::embedding::detail {

/// The map with a d - b c = 1, to rounding of its coefficients, that is nearest to one that
/// rounding has moved off that; it moves by no more than the error it had. A map with coefficients
/// that are not finite stays as it is.
geometry::MoebiusMap on_group(const geometry::MoebiusMap& map);

/// The product of the maps, from left to right, each taken `on_group`: calculated in a hundred
/// digits and then rounded.
geometry::MoebiusMap product_of(std::span<const geometry::MoebiusMap> maps);
/// The same on the hyperboloid: a Lorentz matrix, with M^T J M = J to rounding of its entries.
geometry::Matrix4 matrix_of_product(std::span<const geometry::MoebiusMap> maps);

}  // namespace tripus::embedding::detail
