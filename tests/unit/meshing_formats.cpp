#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/system_error.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/formats/read_mesh.hpp"

// One solid and its surface in every format, recognised by content.

namespace tripus::meshing {
namespace {

const SurfaceMesh kSurface{{{0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
const TetrahedralMesh kSolid{{{0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                             {{0, 1, 2, 3}, {1, 2, 3, 4}}};

template <class Number>
void append(std::string& out, Number x, bool big_endian = false) {
  char bytes[sizeof x];
  std::memcpy(bytes, &x, sizeof x);
  if (big_endian) std::reverse(bytes, bytes + sizeof x);
  out.append(bytes, sizeof x);
}

std::string no_file(const std::string& name) { throw UnusableFile("no " + name); }

SurfaceMesh surface(const std::string& text, const std::string& format) {
  EXPECT_EQ(detect_mesh_format(text, "surface"), format);
  return std::get<SurfaceFile>(read_mesh(text, "surface", no_file)).mesh;
}

TetrahedralMesh solid(const std::string& text, const std::string& format) {
  EXPECT_EQ(detect_mesh_format(text, "solid"), format);
  return std::get<TetrahedralFile>(read_mesh(text, "solid", no_file)).mesh;
}

TEST(MeshingFormats, Obj) {
  const std::string points = "v 0.5 0 0\nv 1 0 0 1.0\nv 0 1 0\nv 0 0 1\n";
  EXPECT_EQ(surface("# made by hand\r\nmtllib x.mtl\no thing\n" + points +
                        "vt 0 0\nvn 0 0 1\ns off\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf 2 3 4\n"
                        "f -4 -1 -2\n",
                    "Wavefront OBJ"),
            kSurface);
}

TEST(MeshingFormats, StlWeldsEqualCorners) {
  std::string text = "solid a name\n", binary(80, ' ');
  binary.replace(0, 5, "solid");  // as some programs write it
  append(binary, std::uint32_t{4});
  for (const Triangle& t : kSurface.triangles) {
    text += "facet normal nan nan nan\nouter loop\n";
    for (int k = 0; k < 3; ++k) append(binary, 0.0f);
    for (const std::uint32_t corner : t) {
      text += "vertex";
      for (const double x : kSurface.points[corner]) {
        text += (x == 0 ? " -0.0" : " " + std::to_string(x));
        append(binary, static_cast<float>(x));
      }
      text += "\n";
    }
    text += "endloop\nendfacet\n";
    append(binary, std::uint16_t{0});
  }
  text += "endsolid a name\n";
  // Points are numbered as they appear: corners 0 2 1 of the first triangle, then 3.
  const SurfaceMesh wanted{{{0.5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                           {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 3, 1}}};
  EXPECT_EQ(surface(text, "STL"), wanted);
  EXPECT_EQ(surface(binary, "STL"), wanted);
}

TEST(MeshingFormats, PlyInEveryCoding) {
  const auto header = [](const std::string& coding) {
    return "ply\nformat " + coding +
           " 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty uchar red\n"
           "property double y\nproperty float32 z\nelement face 4\nproperty list uchar uint "
           "vertex_indices\nproperty list uint8 float texture\nelement edge 1\nproperty int a\n"
           "end_header\n";
  };
  std::string text = header("ascii");
  for (const Point& p : kSurface.points)
    text +=
        std::to_string(p[0]) + " 255 " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  for (const Triangle& t : kSurface.triangles)
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            " 2 0.5 0.5\n";
  EXPECT_EQ(surface(text + "7\n", "PLY"), kSurface);
  for (const bool big_endian : {false, true}) {
    std::string binary = header(big_endian ? "binary_big_endian" : "binary_little_endian");
    for (const Point& p : kSurface.points) {
      append(binary, static_cast<float>(p[0]), big_endian);
      append(binary, std::uint8_t{255});
      append(binary, p[1], big_endian);
      append(binary, static_cast<float>(p[2]), big_endian);
    }
    for (const Triangle& t : kSurface.triangles) {
      append(binary, std::uint8_t{3});
      for (const std::uint32_t corner : t) append(binary, corner, big_endian);
      append(binary, std::uint8_t{1});
      append(binary, 0.5f, big_endian);
    }
    append(binary, std::int32_t{7}, big_endian);
    EXPECT_EQ(surface(binary, "PLY"), kSurface);
  }
}

TEST(MeshingFormats, Medit) {
  EXPECT_EQ(solid(write_medit(kSolid), "Medit mesh"), kSolid);
  const std::string points =
      "MeshVersionFormatted 1\n# comment\nDimension\n3\nVertices\n4\n0.5 0 0 1\n1 0 0 1\n0 1 0 "
      "1\n0 0 1 1\n";
  EXPECT_EQ(
      surface(points + "RequiredVertices 2\n1\n2\nEdges\n1\n1 2 0\nTriangles\n4\n1 3 2 0\n1 2 "
                       "4 0\n2 3 4 0\n1 4 3 0\nEnd\n",
              "Medit mesh"),
      kSurface);
}

TEST(MeshingFormats, VtkOfBothLayouts) {
  EXPECT_EQ(solid(write_vtk(kSolid), "VTK legacy"), kSolid);
  const std::string head =
      "# vtk DataFile Version 5.1\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n";
  std::string binary = head;
  for (const Point& p : kSolid.points)
    for (const double x : p) append(binary, x, true);
  binary += "\nCELLS 4 9\nOFFSETS vtktypeint64\n";
  for (const std::int64_t x : {0, 4, 5, 9}) append(binary, x, true);
  binary += "\nCONNECTIVITY vtktypeint64\n";
  for (const std::int64_t x : {0, 1, 2, 3, 0, 1, 2, 3, 4}) append(binary, x, true);
  binary += "\nCELL_TYPES 3\n";
  for (const std::int32_t x : {10, 1, 10}) append(binary, x, true);
  binary += "\nCELL_DATA 3\nSCALARS t int\n";
  EXPECT_EQ(solid(binary, "VTK legacy"), kSolid);

  std::string faces =
      "# vtk DataFile Version 2.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
      "0.5 0 0 1 0 0 0 1 0 0 0 1\nPOLYGONS 4 16\n";
  for (const Triangle& t : kSurface.triangles)
    faces += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
             "\n";
  EXPECT_EQ(surface(faces, "VTK legacy"), kSurface);
}

TEST(MeshingFormats, TetgenFromEitherFile) {
  for (const int first : {0, 1}) {
    std::string node = "# points\n5 3 1 1\n", ele = "2 4 0\n";
    for (std::size_t i = 0; i < kSolid.points.size(); ++i) {
      node += std::to_string(int(i) + first);
      for (const double x : kSolid.points[i]) node += " " + std::to_string(x);
      node += " 0.25 1\n";
    }
    for (std::size_t i = 0; i < kSolid.tetrahedra.size(); ++i) {
      ele += std::to_string(int(i) + first);
      for (const std::uint32_t corner : kSolid.tetrahedra[i])
        ele += " " + std::to_string(int(corner) + first);
      ele += "\n";
    }
    const ReadFile files = [&](const std::string& name) {
      return name == "folder.x/a.1.node" ? node : name == "folder.x/a.1.ele" ? ele : no_file(name);
    };
    for (const bool by_node : {true, false}) {
      const std::string name = by_node ? "folder.x/a.1.node" : "folder.x/a.1.ele";
      EXPECT_EQ(detect_mesh_format(by_node ? node : ele, name), "TetGen .node and .ele");
      const auto file = std::get<TetrahedralFile>(read_mesh(by_node ? node : ele, name, files));
      EXPECT_EQ(file.mesh, kSolid);
      EXPECT_EQ(file.notes,
                std::vector<std::string>{"attributes and markers of the points not read"});
    }
    // The two in any case of the letters; where there are two of them, in the same.
    for (const char* const given : {"node", "NODE", "Node"})
      for (const char* const other : {"ele", "ELE", "Ele"}) {
        const ReadFile mixed = [&](const std::string& name) {
          return name == std::string("a.") + other ? ele : no_file(name);
        };
        EXPECT_EQ(std::get<TetrahedralFile>(read_mesh(node, std::string("a.") + given, mixed)).mesh,
                  kSolid);
      }
    EXPECT_THROW((void)read_mesh(node, "a.node", no_file), UnusableFile);
  }
}

TEST(MeshingFormats, TriangulationsAreNoMeshes) {
  for (const char* text : {"cPcbbbihq", "OFF", "{\"gluings\": []}", "% Triangulation\nx\n",
                           "<regina>", "# signatures\ncPcbbbihq\n", "", "Tet | glued to:\n", "v"})
    EXPECT_FALSE(detect_mesh_format(text, "x")) << text;
}

}  // namespace
}  // namespace tripus::meshing
