#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "topology/triangulation.hpp"

namespace tripus::topology {

/// The cyclic cover that a class in H^1 describes: tetrahedron t on sheet k has number k T + t, and
/// crossing face f of t leads from sheet k to sheet k + shift_per_face[4 t + f] modulo the degree.
///   shift_per_face  [T x 4]  opposite modulo the degree on the two sides of every glued pair
///   degree                   >= 1
/// The cover is connected if some loop's shifts add up to a unit modulo the degree.
/// Throws InvalidInput naming the face where the shifts do not match, or the edge class around
/// which they do not add up to 0 modulo the degree (the cover would be branched there).
Gluings cyclic_cover(const Gluings& gluings, std::span<const int> shift_per_face,
                     std::size_t degree);

/// Shifts [T x 4] of an infinite cyclic cover: an integer class that is onto Z, so that its cyclic
/// covers of every degree are connected and unbranched. Among the classes of a basis, the one with
/// the smallest shifts. Nothing if H1 is finite or the triangulation is not connected.
/// Dense and exact: cost T^3, meant for small triangulations.
/// Throws Unsupported if the shifts exceed an int.
std::optional<std::vector<int>> primitive_class(const Triangulation& triangulation);

}  // namespace tripus::topology
