#include "parameterise/vtu.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include <fmt/format.h>

#include "base/base64.hpp"
#include "base/error.hpp"
#include "embedding/colour.hpp"

namespace tripus::parameterise {
namespace {

template <class Number>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<Number, double>) return "Float64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
  return "UInt8";
}

/// A DataArray: its length in bytes and its numbers, in base64. Little-endian, as all machines are
/// that this runs on.
template <class Number>
void append_array(std::string& out, std::string_view name, int components,
                  const std::vector<Number>& values, bool is_field = false) {
  std::string bytes(4 + values.size() * sizeof(Number), '\0');
  if (values.size() * sizeof(Number) > 0xffffffffu)
    throw Unsupported("the solid has more numbers than a VTK file of this kind holds");
  const auto length = static_cast<std::uint32_t>(values.size() * sizeof(Number));
  std::memcpy(bytes.data(), &length, 4);
  if (length > 0) std::memcpy(bytes.data() + 4, values.data(), length);
  const auto tuples = values.size() / static_cast<std::size_t>(components);
  out += fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"binary\">\n{}\n"
      "</DataArray>\n",
      vtk_type<Number>(), name, components,
      is_field ? fmt::format(" NumberOfTuples=\"{}\"", tuples) : std::string(),
      encode_base64(bytes));
}

template <class Number>
std::vector<Number> read_array(std::string_view text, const std::string& name) {
  const std::string mark =
      fmt::format("<DataArray type=\"{}\" Name=\"{}\"", vtk_type<Number>(), name);
  std::size_t at = text.find(mark);
  const std::size_t begin = at == std::string_view::npos ? at : text.find('>', at);
  const std::size_t end = begin == std::string_view::npos ? begin : text.find('<', begin);
  if (end == std::string_view::npos)
    throw InvalidInput("it has no array " + quoted(name) +
                       " as tripus parameterise writes it; is it the file of another program?");
  const std::string bytes = decode_base64(text.substr(begin + 1, end - begin - 1));
  std::uint32_t length = 0;
  if (bytes.size() >= 4) std::memcpy(&length, bytes.data(), 4);
  if (bytes.size() < 4 || length != bytes.size() - 4 || length % sizeof(Number) != 0)
    throw InvalidInput("its array " + quoted(name) + " is cut short");
  std::vector<Number> values(length / sizeof(Number));
  if (length > 0) std::memcpy(values.data(), bytes.data() + 4, length);
  return values;
}

}  // namespace

ColouredSolid coloured(const MarkedSolid& solid, std::span<const Vector4> points) {
  ColouredSolid result;
  result.mesh = solid.mesh;
  for (std::size_t t = 0; t < solid.mesh.tetrahedra.size(); ++t)
    result.tetrahedron.push_back(located(solid, middle(image(solid, points, t))).tetrahedron);
  for (const Vector4& point : points)
    result.distance_to_boundary.push_back(located(solid, point).to_boundary);
  return result;
}

std::string write_vtu(MarkedSolid& solid, const HarmonicMap& map, const Quality& quality) {
  const std::size_t cells = solid.mesh.tetrahedra.size(), points = solid.mesh.points.size();
  std::vector<double> place, h3, position, distance;
  std::vector<std::int32_t> tetrahedron, connectivity, offsets, deck, orientation, cell_tetrahedron;
  std::vector<std::uint8_t> types(cells, 10), colour;
  std::vector<double> volume, anisotropy, ratio, cell_distance, matrices;
  for (std::size_t v = 0; v < points; ++v) {
    place.insert(place.end(), solid.mesh.points[v].begin(), solid.mesh.points[v].end());
    h3.insert(h3.end(), map.points[v].data(), map.points[v].data() + 4);
    const Located at = located(solid, map.points[v]);
    tetrahedron.push_back(static_cast<std::int32_t>(at.tetrahedron));
    position.insert(position.end(), at.position.begin(), at.position.end());
    distance.push_back(at.to_boundary);
  }
  std::map<std::uint32_t, std::int32_t> rows;
  const auto row_of = [&](std::uint32_t element) {
    const auto [entry, is_new] = rows.try_emplace(element, static_cast<std::int32_t>(rows.size()));
    if (is_new) {
      const Matrix4& m = solid.group->matrix(element);
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) matrices.push_back(m(i, j));
    }
    return entry->second;
  };
  row_of(0);
  for (std::size_t t = 0; t < cells; ++t) {
    const std::uint32_t first = solid.group->inverse(solid.corners[4 * t]);
    for (std::size_t v = 0; v < 4; ++v) {
      connectivity.push_back(static_cast<std::int32_t>(solid.mesh.tetrahedra[t][v]));
      deck.push_back(row_of(solid.group->product(first, solid.corners[4 * t + v])));
    }
    offsets.push_back(static_cast<std::int32_t>(4 * (t + 1)));
    const CellQuality& cell = quality.cells[t];
    orientation.push_back(cell.orientation);
    volume.push_back(cell.volume);
    anisotropy.push_back(cell.anisotropy);
    ratio.push_back(cell.volume_ratio);
    const Located at = located(solid, middle(image(solid, map.points, t)));
    cell_tetrahedron.push_back(static_cast<std::int32_t>(at.tetrahedron));
    cell_distance.push_back(at.to_boundary);
    const embedding::Colour c = embedding::tetrahedron_colour(at.tetrahedron);
    colour.insert(colour.end(), c.begin(), c.end());
  }
  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt32\">\n<UnstructuredGrid>\n<FieldData>\n";
  append_array(out, "deck_matrices", 16, matrices, true);
  append_array<double>(out, "energy", 1, {map.energy}, true);
  append_array<double>(out, "image_volume", 1, {quality.image_volume}, true);
  append_array<double>(out, "manifold_volume", 1, {quality.manifold_volume}, true);
  out += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                     points, cells);
  append_array(out, "Points", 3, place);
  out += "</Points>\n<Cells>\n";
  append_array(out, "connectivity", 1, connectivity);
  append_array(out, "offsets", 1, offsets);
  append_array(out, "types", 1, types);
  out += "</Cells>\n<PointData>\n";
  append_array(out, "point_h3", 4, h3);
  append_array(out, "tetrahedron", 1, tetrahedron);
  append_array(out, "position", 3, position);
  append_array(out, "distance_to_boundary", 1, distance);
  out += "</PointData>\n<CellData>\n";
  append_array(out, "deck", 4, deck);
  append_array(out, "orientation", 1, orientation);
  append_array(out, "volume", 1, volume);
  append_array(out, "anisotropy", 1, anisotropy);
  append_array(out, "volume_ratio", 1, ratio);
  append_array(out, "tetrahedron", 1, cell_tetrahedron);
  append_array(out, "distance_to_boundary", 1, cell_distance);
  append_array(out, "colour", 3, colour);
  out += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return out;
}

ColouredSolid read_coloured_solid(std::string_view vtu) {
  ColouredSolid solid;
  const auto places = read_array<double>(vtu, "Points");
  const auto connectivity = read_array<std::int32_t>(vtu, "connectivity");
  const std::size_t cell_data = std::min(vtu.find("<CellData>"), vtu.size());
  const auto tetrahedron = read_array<std::int32_t>(vtu.substr(cell_data), "tetrahedron");
  solid.distance_to_boundary = read_array<double>(vtu, "distance_to_boundary");
  const std::size_t points = places.size() / 3, cells = connectivity.size() / 4;
  if (points == 0 || cells == 0 || places.size() % 3 != 0 || connectivity.size() % 4 != 0 ||
      tetrahedron.size() != cells || solid.distance_to_boundary.size() != points)
    throw InvalidInput("its arrays have lengths that do not fit together");
  for (std::size_t v = 0; v < points; ++v) {
    solid.mesh.points.push_back({places[3 * v], places[3 * v + 1], places[3 * v + 2]});
    for (const double x : solid.mesh.points.back())
      if (!std::isfinite(x)) throw InvalidInput(fmt::format("point {} is not finite", v));
    if (!std::isfinite(solid.distance_to_boundary[v]))
      throw InvalidInput(fmt::format("distance_to_boundary of point {} is not finite", v));
  }
  for (std::size_t t = 0; t < cells; ++t) {
    meshing::Tetrahedron corners{};
    for (std::size_t v = 0; v < 4; ++v) {
      const std::int32_t corner = connectivity[4 * t + v];
      if (corner < 0 || static_cast<std::size_t>(corner) >= points)
        throw InvalidInput(
            fmt::format("cell {} has the corner {}, and there are {} points", t, corner, points));
      corners[v] = static_cast<std::uint32_t>(corner);
    }
    solid.mesh.tetrahedra.push_back(corners);
    solid.tetrahedron.push_back(static_cast<std::uint32_t>(std::max(tetrahedron[t], 0)));
  }
  return solid;
}

}  // namespace tripus::parameterise
