#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"

namespace tripus::python {

namespace nb = nanobind;

/// Harmonic maps of solids; the other parts of the extension are in bindings.hpp.
void bind_parameterise(nb::module_& module);

using PointArray = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using IndexArray = nb::ndarray<const std::uint32_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Points [n x 3] and triangles [n x 3] or tetrahedra [n x 4] as a mesh.
/// Throws InvalidInput for other shapes and for points that there are not.
inline meshing::MeshFile mesh_of(const PointArray& points, const IndexArray& cells) {
  if (points.shape(1) != 3) throw InvalidInput("points are an array [n x 3]");
  std::vector<meshing::Point> places(points.shape(0));
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) places[i][k] = points.data()[3 * i + k];
  const std::size_t corners = cells.shape(1);
  if (corners != 3 && corners != 4)
    throw InvalidInput("cells are an array [n x 3] of triangles or [n x 4] of tetrahedra");
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells.data()[i] >= places.size())
      throw InvalidInput("cell " + std::to_string(i / corners) + " has point " +
                         std::to_string(cells.data()[i]) + "; there are " +
                         std::to_string(places.size()) + ", counted from 0");
  const auto copy_to = [&](auto& to) {
    to.resize(cells.shape(0));
    for (std::size_t i = 0; i < to.size(); ++i)
      std::copy_n(cells.data() + corners * i, corners, to[i].begin());
  };
  if (corners == 3) {
    meshing::SurfaceFile file;
    file.mesh.points = std::move(places);
    copy_to(file.mesh.triangles);
    return file;
  }
  meshing::TetrahedralFile file;
  file.mesh.points = std::move(places);
  copy_to(file.mesh.tetrahedra);
  return file;
}

}  // namespace tripus::python
