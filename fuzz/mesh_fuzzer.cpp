// One source for the fuzzers of all mesh readers: TRIPUS_MESH_READER is the reader's name.
#include "fuzz/fuzzer.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/mend.hpp"
#include "meshing/validate.hpp"
#include "meshing/validate_tetrahedra.hpp"

namespace tripus::meshing {
namespace {

/// TetGen's two files, with a zero byte between them.
TetrahedralFile read_pair(std::string_view text) {
  const std::size_t end = text.find('\0');
  return read_tetgen(text.substr(0, end),
                     end == std::string_view::npos ? "" : text.substr(end + 1));
}

/// Numbers that a writer wrote read back the same, and what is valid is consistent.
void check(const SurfaceFile& file) {
  const SurfaceFile again = read_off(write_off(file.mesh));
  fuzz::require(again.mesh.triangles == file.mesh.triangles);
  fuzz::require(write_off(again.mesh) == write_off(file.mesh));  // nan is not equal to itself
  const SurfaceFile mended = mend(file);
  const Region region = require_valid(mended.mesh, mended.lines);
  fuzz::require(region.outermost < region.components.size());
  for (const SurfaceComponent& component : region.components) fuzz::require(component.genus >= 0);
}

void check(const TetrahedralFile& file) {
  const auto again = read_vtk(write_vtk(file.mesh));
  if (!file.mesh.tetrahedra.empty())
    fuzz::require(std::get<TetrahedralFile>(again).mesh.tetrahedra == file.mesh.tetrahedra);
  const TetrahedralFile mended = mend(file);
  fuzz::check_table(require_valid(mended.mesh, mended.lines).gluings);
}

void check(const MeshFile& file) {
  std::visit([](const auto& each) { check(each); }, file);
}

}  // namespace
}  // namespace tripus::meshing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tripus;
  try {
    using namespace tripus::meshing;
    check(TRIPUS_MESH_READER(fuzz::as_text(data, size)));
  } catch (const InvalidInput&) {
  }
  return 0;
}
