#include "meshing/find_tetgen.hpp"

#include <cstdlib>
#include <filesystem>

#include <unistd.h>

#include "base/error.hpp"

namespace tripus::meshing {

std::string find_tetgen() {
  namespace fs = std::filesystem;
  constexpr const char* kName = "tripus-tetgen";
  if (const char* named = std::getenv("TRIPUS_TETGEN"); named != nullptr && *named != '\0') {
    if (access(named, X_OK) == 0) return named;
    throw Unsupported("the environment variable TRIPUS_TETGEN names " + quoted(named, 200) +
                      ", which is not a program that can be run");
  }
  std::error_code status;
  const fs::path folder = fs::read_symlink("/proc/self/exe", status).parent_path();
  for (const fs::path& place : {folder / kName, folder.parent_path() / "libexec" / "tripus" / kName,
                                fs::path(TRIPUS_LIBEXEC_DIR) / kName}) {
    if (access(place.c_str(), X_OK) == 0) return place.string();
  }
  throw Unsupported(
      "the program tripus-tetgen, which fills surfaces with tetrahedra, was found neither beside "
      "the running program nor in libexec/tripus: build with -DTRIPUS_WITH_TETGEN=ON (Debian "
      "package libtet1.5-dev), or name it in the environment variable TRIPUS_TETGEN. Tetrahedral "
      "meshes can be read without it");
}

}  // namespace tripus::meshing
