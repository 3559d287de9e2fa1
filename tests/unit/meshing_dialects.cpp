#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "base/base64.hpp"
#include "base/compression.hpp"
#include "base/error.hpp"
#include "meshing/formats/read_mesh.hpp"
#include "meshing/formats/write_surface.hpp"
#include "meshing/mend.hpp"
#include "meshing/validate.hpp"

// One small surface in the dialects that programs write; larger files: tests/dialects.

namespace tripus::meshing {
namespace {

const SurfaceMesh kTetrahedron{{{0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

SurfaceFile read(const std::string& text, const std::string& name = "x") {
  const auto no_file = [](const std::string& other) -> std::string {
    throw InvalidInput("no " + other);
  };
  return std::get<SurfaceFile>(read_mesh(text, name, no_file));
}

TEST(OffDialects, AreReadByTokens) {
  const std::string points = "0.5 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  for (const std::string& text :
       {"OFF\n4 4 6\n" + points + faces,
        "OFF\n4\n4\n6\n" + points + faces,
        "OFF4 4 6\n" + points + faces,
        "OFF 4 4 6 0.5 0 0 1 0 0 0 1 0 0 0 1\n" + faces,
        "OFF\n4 4\n" + points + faces,
        "{ OFF\n4 4 6\n" + points + faces + "}\n",
        "{ = OFF\n4 4 6\n" + points + faces + "}\n",
        "# c\nOFF # d\n4 4 6 # e\n" + points + faces,
        "OFF\n4 4 6\n" + points + "3 0 2 1 3 0 1 3\n3\n1\n2 3 3 0 3 2",
        "OFF\n4 4 6\n" + points + "3 0 2 1 255 0 0\n3 0 1 3 7\n3 1 2 3\n3 0 3 2 0.5 0.5 0.5 1\n",
        "COFF\n4 4 6\n0.5 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n0 0 1 1 0 0 1\n" + faces,
        "COFF\n4 4 6\n0.5 0 0 9 8 7\n1 0 0 9 8 7\n0 1 0 9 8 7\n0 0 1 9 8 7\n" + faces,
        "OFF\n4 4\n0.5 0 0 9 8 7\n1 0 0 9 8 7\n0 1 0 9 8 7\n0 0 1 9 8 7\n" + faces,
        "NOFF\n4 4 6\n0.5 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n" + faces,
        "4OFF\n4 4 6\n1 0 0 2\n1 0 0 1\n0 1 0 1\n0 0 1 1\n" + faces,
        "nOFF 3\n4 4 6\n" + points + faces,
        "off\n4 4 6\n" + points + faces,
        "{appearance { +edge material { diffuse 1 0 0 } }\nOFF 4 4 6\n" + points + faces + "}\n",
        "appearance {+edge}\nOFF\n4 4 6\n" + points + faces,
        "{ define tetrahedron OFF\n4 4 6\n" + points + faces + "}\n",
        "LIST { = OFF4 4 6\n" + points + faces + "}\n",
        "4nOFF 3 4 4 6\n1 0 0 2\n1 0 0 1\n0 1 0 1\n0 0 1 1\n" + faces,
        "OFF\n4 5 6\n" + points + "2 0 1\n" + faces}) {
    SCOPED_TRACE(text);
    EXPECT_EQ(read(text).mesh, kTetrahedron);
    std::string old = text;
    for (char& c : old)
      if (c == '\n') c = '\r';
    EXPECT_EQ(read(old).mesh, kTetrahedron);
  }
}

TEST(OffDialects, TheKeywordMayBeMissingWhereTheNameTells) {
  const std::string text =
      "4 4 6\n0.5 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  EXPECT_EQ(read(text, "a.OFF").mesh, kTetrahedron);
  EXPECT_FALSE(detect_mesh_format(text, "a.txt"));
}

TEST(OffDialects, SeveralSurfacesAreRefused) {
  const std::string one =
      "{ OFF 4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n}";
  EXPECT_EQ(read("LIST " + one).mesh.triangles.size(), 4u);
  try {
    read("LIST " + one + " " + one);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("several surfaces"), std::string::npos);
  }
}

/// As Geomview writes it; `counts` follow the corners of each face.
std::string binary_off(const std::string& head, std::size_t extra, std::int32_t colours) {
  std::string text = head + " BINARY\n";
  const auto append = [&](auto x) {
    char bytes[sizeof x];
    std::memcpy(bytes, &x, sizeof x);
    text.append(std::reverse_iterator(bytes + sizeof x), std::reverse_iterator(bytes));
  };
  for (const std::int32_t count : {4, 4, 6}) append(count);
  for (const Point& p : kTetrahedron.points) {
    for (const double x : p) append(static_cast<float>(x));
    for (std::size_t k = 0; k < extra; ++k) append(0.5f);
  }
  for (const Triangle& t : kTetrahedron.triangles) {
    append(std::int32_t{3});
    for (const std::uint32_t corner : t) append(static_cast<std::int32_t>(corner));
    append(colours);
    for (std::int32_t k = 0; k < colours; ++k) append(0.5f);
  }
  return text;
}

TEST(OffDialects, WhatIsNotReadOfBinaryOnesIsSaid) {
  using Notes = std::vector<std::string>;
  const std::string points = "normals, colours and textures of the points not read";
  const std::string faces = "colours of the faces not read";
  struct Case {
    const char* head;
    std::size_t extra;
    std::int32_t colours;
    Notes notes;
  };
  for (const Case& each :
       {Case{"OFF", 0, 0, {}}, Case{"COFF", 4, 0, {points}}, Case{"NOFF", 3, 1, {points, faces}},
        Case{"OFF", 0, 3, {faces}}, Case{"STOFF", 2, 4, {points, faces}}}) {
    const SurfaceFile file = read(binary_off(each.head, each.extra, each.colours));
    EXPECT_EQ(file.mesh, kTetrahedron) << each.head;
    EXPECT_EQ(file.notes, each.notes) << each.head;
  }
}

TEST(OffDialects, CountsOnThreeLinesDoNotMoveThePoints) {
  const SurfaceFile file = read(
      "OFF\n4\n4\n0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n"
      "3 0 3 2\n3 1 2 3\n");
  EXPECT_EQ(file.mesh.points[1], (Point{1, 0, 0}));
  EXPECT_EQ(file.lines.points[0], 5u);
}

TEST(ObjDialects, AreRead) {
  const std::string points = "v 0.5 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  for (const std::string& text :
       {points + faces, "lod 1\nbevel off\nshadow_obj x\nc_interp off\n" + points + faces,
        "f 1 3 2\n" + points + "f 1 2 4\nf 2 3 4\nf 1 4 3\n",
        points + "f 1 \\\n3 2\nf 1 2\\\n 4\nf 2 3 4\nf 1 4 3\n",
        "v 0.5 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nv 0 0 1 1 0 0\n" + faces,
        points + "l 1 2\np 1\n" + faces})
    EXPECT_EQ(read(text).mesh, kTetrahedron) << text;
  for (const char* looks : {"vn 0 0 1\n", "vt 0 0\n", "usemtl red\n"})
    EXPECT_EQ(read(points + looks + faces).notes,
              std::vector<std::string>{"normals, textures and materials not read"});
  EXPECT_TRUE(read("o x\ng y\ns 1\n" + points + faces).notes.empty());
}

TEST(StlDialects, AreRead) {
  std::string text = "SOLID A B\n", apart = "solid\n";
  for (const Triangle& t : kTetrahedron.triangles) {
    text += "FACET NORMAL 0 0 0\nOUTER LOOP\n";
    apart += "facet normal 0 0 0 outer loop ";
    for (const std::uint32_t corner : t)
      for (const auto& [out, word] : {std::pair(&text, "VERTEX"), std::pair(&apart, "vertex")}) {
        *out += word;
        for (const double x : kTetrahedron.points[corner]) *out += " " + std::to_string(x);
        *out += "\n";
      }
    text += "ENDLOOP\nENDFACET\n";
    apart += "end loop end facet\n";
  }
  const std::string binary = surface_format_of("x.STL").write(kTetrahedron);
  std::string no_count = binary, solid = binary;
  no_count.replace(80, 4, 4, '\0');
  solid.replace(0, 5, "solid");
  const SurfaceMesh wanted = read(binary).mesh;
  EXPECT_EQ(wanted.triangles.size(), 4u);
  EXPECT_EQ(wanted.points.size(), 4u);
  std::string broken_normals = text;
  for (std::size_t at = 0; (at = broken_normals.find("NORMAL 0", at)) != std::string::npos; ++at)
    broken_normals.replace(at, 8, "NORMAL\n0");
  EXPECT_EQ(read(text).notes.size(), 1u);  // without "endsolid"
  EXPECT_TRUE(read(text + "ENDSOLID\n").notes.empty());
  for (const std::string& each :
       {text, text + std::string("\0\0\x1a", 3), broken_normals + "endsolid",
        text + "ENDSOLID\n" + std::string("\0\x1a", 2), text + "ENDSOLID\n\x1a"})
    EXPECT_EQ(read(each).mesh, wanted);
  EXPECT_THROW(read(text + "FACET NORMAL 0 0"), InvalidInput);
  for (const std::string& each : {text + "ENDSOLID\n", apart + "end solid\n", binary + "!",
                                  binary + std::string(50, '\0'), no_count, solid, solid + "x"})
    EXPECT_EQ(read(each).mesh, wanted);
  EXPECT_THROW(read(binary.substr(0, 200), "x.stl"), InvalidInput);
}

TEST(VtkDialects, OldIndicesOfEightBytesAreReadAsWell) {
  for (const bool wide : {false, true}) {
    std::string text = "# vtk datafile version 5.1\nx\nbinary\ndataset polydata\npoints 4 float\n";
    const auto append = [&](auto x) {
      char bytes[sizeof x];
      std::memcpy(bytes, &x, sizeof x);
      text.append(std::reverse_iterator(bytes + sizeof x), std::reverse_iterator(bytes));
    };
    const auto index = [&](std::int32_t x) { wide ? append(std::int64_t{x}) : append(x); };
    for (const Point& p : kTetrahedron.points)
      for (const double x : p) append(static_cast<float>(x));
    text += "\nMETADATA\nINFORMATION 0\n\nPOLYGONS 5 12\nOFFSETS vtkIdType\n";
    for (std::int32_t i = 0; i <= 4; ++i) index(3 * i);
    text += "\nCONNECTIVITY vtkIdType\n";
    for (const Triangle& t : kTetrahedron.triangles)
      for (const std::uint32_t corner : t) index(static_cast<std::int32_t>(corner));
    text += "\nCELL_DATA 4\nSCALARS x int\n";
    const SurfaceFile file = read(text);
    EXPECT_EQ(file.mesh, kTetrahedron);
    EXPECT_EQ(file.notes.size(), 1u);
  }
}

TEST(VtkDialects, SectionsInAnyOrder) {
  const SurfaceFile file = read(
      "# vtk DataFile Version 3.0\nx\nASCII\nFIELD f 2\na 1 2 double\n1 2\nb 1 1 string\ntwo "
      "words\n"
      "DATASET UNSTRUCTURED_GRID\nCELL_TYPES 3\n6 9 1\nCELLS 3 12\n4 0 2 1 3\n4 0 1 3 2\n1 0\n"
      "POINTS 4 int\n0 0 0 1 0 0 0 1 0 0 0 1\n");
  EXPECT_EQ(file.mesh.triangles.size(), 4u);
  EXPECT_EQ(file.mesh.triangles[0], (Triangle{0, 2, 1}));
  EXPECT_EQ(file.mesh.triangles[1], (Triangle{1, 2, 3}));
  ASSERT_EQ(file.notes.size(), 4u);
  EXPECT_EQ(std::ranges::count(file.notes, "data of the points, the cells and the whole not read"),
            1);
  EXPECT_EQ(file.notes[3],
            "1 face of more than three corners cut into triangles, 1 of them not planar");
}

TEST(PlyDialects, StripsAndFacesBeforePoints) {
  const SurfaceFile file = read(
      "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\n"
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "10 0 2 1 3 -1 0 3 2 -1 0\n"
      "0.5 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  EXPECT_EQ(file.mesh.triangles, (std::vector<Triangle>{{0, 2, 1}, {1, 2, 3}, {0, 3, 2}}));
}

TEST(GmshDialects, VersionFour) {
  const SurfaceFile file = read(
      "$Comments\nnot $Nodes\n$EndComments\n$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 "
      "0\n1 0 0 0 1 1 1 0 0\n$EndEntities\n"
      "$Nodes\n2 4 3 9\n2 1 0 3\n3\n5\n9\n0.5 0 0\n1 0 0\n0 1 0\n2 1 1 1\n7\n0 0 1 0.5 0.5\n"
      "$EndNodes\n$Elements\n2 5 1 5\n2 1 2 4\n1 3 9 5\n2 3 5 7\n3 5 9 7\n4 3 7 9\n0 1 15 1\n5 3\n"
      "$EndElements\n");
  EXPECT_EQ(file.mesh, kTetrahedron);
}

TEST(GmshDialects, GroupsThatDifferAreSaid) {
  const std::vector<std::string> note{"physical groups and data not read"};
  for (const int other : {1, 2}) {
    const std::string group = std::to_string(other);
    const SurfaceFile file = read(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0.5 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
        "$EndNodes\n$Elements\n4\n1 2 2 1 1 1 3 2\n2 2 2 " +
        group +
        " 1 1 2 4\n"
        "3 2 2 1 1 2 3 4\n4 2 2 1 7 1 4 3\n$EndElements\n");
    EXPECT_EQ(file.mesh, kTetrahedron);
    EXPECT_EQ(file.notes, other == 1 ? std::vector<std::string>{} : note);
  }
}

TEST(MeditDialects, ReferencesThatDifferAreSaid) {
  const std::vector<std::string> note{"reference numbers, which differ, not read"};
  for (const char* references : {"0 0 0", "5 5 0", "0 1 0", "1 1 1", "1 0 2"}) {
    const std::string a(1, references[0]), b(1, references[2]), c(1, references[4]);
    const SurfaceFile file =
        read("MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0.5 0 0 " + a + "\n1 0 0 " + a +
             "\n0 1 0 " + b + "\n0 0 1 " + a + "\nTriangles\n4\n1 3 2 " + c + "\n1 2 4 " + c +
             "\n2 3 4 " + c + "\n1 4 3 " + c + "\nEnd\n");
    EXPECT_EQ(file.mesh, kTetrahedron);
    EXPECT_EQ(file.notes, a == b ? std::vector<std::string>{} : note) << references;
  }
}

TEST(VtkXmlDialects, TextAndCompressedBase64) {
  const std::string head =
      "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece><Points>"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
      "0.5 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Polys>";
  const std::string text =
      head +
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 2 1 0 1 3 1 2 3 0 3 2"
      "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 9 12</DataArray>"
      "</Polys></Piece></PolyData></VTKFile>";
  EXPECT_EQ(read(text).mesh, kTetrahedron);
  EXPECT_TRUE(read(text).notes.empty());
  std::string bare = text;
  for (std::size_t at = 0; (at = bare.find(" format=\"ascii\"")) != std::string::npos;)
    bare.erase(at, 15);
  EXPECT_EQ(read(bare).mesh, kTetrahedron);
  bare.insert(bare.find("<Piece>"),
              "<FieldData><DataArray type=\"Int8\">1</DataArray></FieldData>");
  EXPECT_EQ(read(bare).notes, std::vector<std::string>{"data of the whole not read"});
  // Lengths and numbers in one piece of base64, or each in its own.
  const std::string numbers("\x03\0\0\0\x06\0\0\0\x09\0\0\0\x0c\0\0\0", 16);
  const std::string length("\x10\0\0\0", 4);
  for (const std::string& coded :
       {encode_base64(length + numbers), encode_base64(length) + encode_base64(numbers)}) {
    std::string mixed = text;
    const std::string from = "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6 9 12";
    mixed.replace(
        mixed.find(from), from.size(),
        "<DataArray type=\"Int32\" Name=\"offsets\" format=\"binary\">\n " + coded + "\n");
    EXPECT_EQ(read(mixed).mesh, kTetrahedron);
  }
}

TEST(Base64, Decodes) {
  for (const char* text : {"", "a", "ab", "abc", "abcd", "\xff\xfe\xfd"})
    EXPECT_EQ(decode_base64(encode_base64(text)), text);
  EXPECT_EQ(encode_base64("light w"), "bGlnaHQgdw==");  // RFC 4648's alphabet
}

TEST(Compression, RefusesWhatIsCutOrDamaged) {
  // What gzip makes of "tripus".
  const std::string packed("\x1f\x8b\x08\0\0\0\0\0\0\x03\x2b\x29\xca\x2c\x28\x2d\x06\0", 18);
  EXPECT_TRUE(is_gzip(packed));
  EXPECT_THROW((void)gunzip(packed, 100), InvalidInput);  // its checksum is missing
  EXPECT_THROW((void)gunzip("\x1f\x8b", 100), InvalidInput);
  EXPECT_THROW((void)inflate_block("no zlib", 100), InvalidInput);
}

/// A cube with sides of 1, of two triangles each.
SurfaceMesh cube() {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Mends, and says whether that is valid.
std::vector<std::string> notes_after_mending(SurfaceMesh mesh) {
  SurfaceFile file = mend({std::move(mesh), {}});
  EXPECT_NO_THROW((void)require_valid(file.mesh, file.lines));
  return file.notes;
}

TEST(Mending, LeavesGoodSurfacesAlone) {
  const SurfaceFile file = mend({cube(), {}});
  EXPECT_EQ(file.mesh, cube());
  EXPECT_TRUE(file.notes.empty());
}

TEST(Mending, SplitsTJunctions) {
  SurfaceMesh mesh = cube();
  const double third = 1.0 / 3;
  mesh.points.push_back({third, 0, 0});  // on the edge 0-1, in the triangles of one side only
  mesh.points.push_back({2 * third, 0, 0});
  mesh.triangles[0] = {0, 2, 8};
  mesh.triangles.push_back({8, 2, 9});
  mesh.triangles.push_back({9, 2, 1});
  EXPECT_EQ(notes_after_mending(mesh),
            std::vector<std::string>{"1 triangle split at points in the middle of a side"});
  for (double& x : mesh.points[8]) x += 3e-8;  // as single precision leaves it
  EXPECT_EQ(notes_after_mending(mesh),
            std::vector<std::string>{"1 triangle split at points in the middle of a side"});
}

TEST(Mending, WeldsCracksOfRounding) {
  for (const double crack : {1e-16, 1e-12, 1e-9, 1e-7, 4e-6}) {
    SurfaceMesh mesh = cube();
    mesh.points.push_back({crack, 0, 0});
    mesh.triangles[0][0] = 8;
    EXPECT_EQ(notes_after_mending(mesh).size(), 1u) << crack;
  }
}

TEST(Mending, LeavesHolesAndWideCracksOpen) {
  SurfaceMesh mesh = cube();
  mesh.triangles.pop_back();
  EXPECT_THROW((void)require_valid(mend({mesh, {}}).mesh), InvalidInput);
  mesh = cube();
  mesh.points.push_back({1e-3, 0, 0});
  mesh.triangles[0][0] = 8;
  const SurfaceFile file = mend({mesh, {}});
  EXPECT_EQ(file.mesh, mesh);
}

TEST(Mending, DropsNeedlesAndCollapsedEdges) {
  SurfaceMesh mesh = cube();
  mesh.points.push_back({0.5, 0, 0});
  mesh.triangles.push_back({0, 1, 8});  // without area, between the edge 0-1 and its halves
  mesh.triangles[0] = {0, 2, 8};
  mesh.triangles.push_back({8, 2, 1});
  std::swap(mesh.triangles[12][0], mesh.triangles[12][1]);
  const auto notes = notes_after_mending(mesh);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[1], "1 triangle without area left out");
}

TEST(Mending, MergesSplitPointsAndKeepsTheNumbersOfTheFile) {
  SurfaceMesh split;
  split.points.push_back({9, 9, 9});
  for (const Triangle& t : cube().triangles)
    for (const std::uint32_t corner : t) split.points.push_back(cube().points[corner]);
  for (std::uint32_t t = 0; t < 12; ++t)
    split.triangles.push_back({3 * t + 1, 3 * t + 2, 3 * t + 3});
  EXPECT_EQ(notes_after_mending(split),
            (std::vector<std::string>{"28 points merged with others in the same place",
                                      "1 point that no triangle has left out"}));
  split.triangles.erase(split.triangles.begin());
  const SurfaceFile open = mend({split, {}});
  try {
    (void)require_valid(open.mesh, open.lines);
    ADD_FAILURE();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("edge 2-3 is open"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace tripus::meshing
