#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <ostream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "base/base64.hpp"
#include "embedding/colour.hpp"
#include "embedding/detail/bytes.hpp"
#include "embedding/export/mesh_formats.hpp"

// glTF 2.0: a JSON document and a buffer of bytes, in one binary file (.glb) or with the buffer as
// base64 within the JSON (.gltf). Each tetrahedron is a mesh of its own with a material of its
// colour; its cells are one list of triangles.
// Source: Khronos, glTF 2.0 Specification, sections 3.6 and 4.4.

namespace tripus::embedding {
namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962, kElementBuffer = 34963;

struct Part {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  std::size_t points = 0, corners = 0;
  std::size_t point_offset = 0, corner_offset = 0;
};

/// All bytes, and what of them belongs to each tetrahedron.
struct Buffer {
  std::string bytes;
  std::map<std::uint32_t, Part> parts;
};

Buffer buffer_of(const Tessellation& tessellation) {
  Buffer buffer;
  const auto cells = tessellation.cells();
  for (const Cell& cell : cells) buffer.parts[cell.tetrahedron];
  std::ostringstream out;
  detail::ByteBuffer bytes(std::endian::little);
  for (auto& [tetrahedron, part] : buffer.parts) {
    part.point_offset = static_cast<std::size_t>(out.tellp());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].tetrahedron != tetrahedron) continue;
      for (const Vector3& point : tessellation.points(c)) {
        for (Eigen::Index k = 0; k < 3; ++k) {
          const auto x = static_cast<float>(point[k]);
          bytes.append(x);
          part.low[k] = std::min(part.low[k], static_cast<double>(x));
          part.high[k] = std::max(part.high[k], static_cast<double>(x));
        }
        ++part.points;
      }
      bytes.write_to(out);
    }
    part.corner_offset = static_cast<std::size_t>(out.tellp());
    std::uint32_t first = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].tetrahedron != tetrahedron) continue;
      for (const auto& triangle : tessellation.triangles(c))
        for (const std::uint32_t corner : triangle) bytes.append(first + corner);
      part.corners += 3 * triangle_count(tessellation.subdivisions(c));
      first += static_cast<std::uint32_t>(point_count(tessellation.subdivisions(c)));
      bytes.write_to(out);
    }
  }
  buffer.bytes = std::move(out).str();
  return buffer;
}

std::string document_of(const Buffer& buffer, const std::string& uri) {
  std::string nodes, meshes, materials, accessors, views, scene;
  int n = 0;
  for (const auto& [tetrahedron, part] : buffer.parts) {
    const char* comma = n == 0 ? "" : ",";
    const Colour colour = tetrahedron_colour(tetrahedron);
    // Colours of materials are linear, those of screens about the power 2.2 of that.
    const auto linear = [&](std::size_t k) { return std::pow(colour[k] / 255.0, 2.2); };
    scene += fmt::format("{}{}", comma, n);
    nodes += fmt::format("{}{{\"mesh\":{},\"name\":\"tetrahedron_{}\"}}", comma, n, tetrahedron);
    meshes += fmt::format(
        "{}{{\"primitives\":[{{\"attributes\":{{\"POSITION\":{}}},\"indices\":{},"
        "\"material\":{}}}]}}",
        comma, 2 * n, 2 * n + 1, n);
    materials += fmt::format(
        "{}{{\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{:.6f},{:.6f},{:.6f},1],"
        "\"metallicFactor\":0,\"roughnessFactor\":0.8}}}}",
        comma, linear(0), linear(1), linear(2));
    accessors += fmt::format(
        "{}{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"VEC3\","
        "\"min\":[{},{},{}],\"max\":[{},{},{}]}},"
        "{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"SCALAR\"}}",
        comma, 2 * n, kFloat, part.points, part.low[0], part.low[1], part.low[2], part.high[0],
        part.high[1], part.high[2], 2 * n + 1, kUnsignedInt, part.corners);
    views += fmt::format(
        "{}{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{}}},"
        "{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{}}}",
        comma, part.point_offset, 12 * part.points, kArrayBuffer, part.corner_offset,
        4 * part.corners, kElementBuffer);
    ++n;
  }
  return fmt::format(
      "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"Tripus\"}},\"scene\":0,"
      "\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],\"meshes\":[{}],\"materials\":[{}],"
      "\"accessors\":[{}],\"bufferViews\":[{}],\"buffers\":[{{{}\"byteLength\":{}}}]}}",
      scene, nodes, meshes, materials, accessors, views, uri, buffer.bytes.size());
}

/// The bytes of numbers, the least significant first.
std::string words(std::initializer_list<std::uint32_t> numbers) {
  std::string bytes;
  for (const std::uint32_t number : numbers)
    for (int shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<char>(number >> shift & 0xff));
  return bytes;
}

}  // namespace

std::size_t write_gltf(std::ostream& out, const Tessellation& tessellation) {
  const Buffer buffer = buffer_of(tessellation);
  out << document_of(buffer, "\"uri\":\"data:application/octet-stream;base64," +
                                 encode_base64(buffer.bytes) + "\",")
      << '\n';
  return tessellation.cells().size();
}

std::size_t write_glb(std::ostream& out, const Tessellation& tessellation) {
  constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2, kJson = 0x4e4f534a, kBin = 0x004e4942;
  const Buffer buffer = buffer_of(tessellation);
  std::string document = document_of(buffer, "");
  document.resize((document.size() + 3) / 4 * 4, ' ');  // chunks are multiples of 4 bytes
  const auto size = [](const std::string& text) { return static_cast<std::uint32_t>(text.size()); };
  out << words({kMagic, kVersion, 28 + size(document) + size(buffer.bytes), size(document), kJson})
      << document << words({size(buffer.bytes), kBin});
  out << buffer.bytes;
  return tessellation.cells().size();
}

}  // namespace tripus::embedding
