#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "meshing/manifold.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/data_folder.hpp"

// Every file of tests/broken-meshes gives the message that its table says: never an answer, never a
// crash. The table and the folder must list the same files.

namespace tripus::meshing {
namespace {

const std::string kFolder = testing::data_folder() + "/../tests/broken-meshes/";

std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InvalidInput("cannot open " + path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// File to message.
std::map<std::string, std::string> table(const std::string& name = "messages.tsv") {
  std::map<std::string, std::string> messages;
  std::istringstream in(content_of(kFolder + name));
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') {
      const auto parts = testing::split(line, '\t');
      messages[parts.at(0)] = parts.at(1);
    }
  return messages;
}

TEST(MeshingBroken, EachFileGivesItsMessage) {
  const auto messages = table();
  EXPECT_GE(messages.size(), 55u);
  for (const auto& [name, message] : messages) {
    SCOPED_TRACE(name);
    try {
      manifold_of(read_mesh(content_of(kFolder + name), kFolder + name, content_of));
      ADD_FAILURE() << "accepted";
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos)
          << "expected: " << message << "\nsaid:     " << error.what();
    }
  }
}

TEST(MeshingBroken, MendedFilesSayWhatWasDone) {
  for (const auto& [name, note] : table("mended.tsv")) {
    SCOPED_TRACE(name);
    const MeshedManifold solid =
        manifold_of(read_mesh(content_of(kFolder + name), kFolder + name, content_of));
    EXPECT_EQ(solid.notes, std::vector{note});
  }
}

TEST(MeshingBroken, TheTableListsEveryFile) {
  auto messages = table();
  messages.merge(table("mended.tsv"));
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const auto& path = entry.path();
    if (path.extension() == ".tsv") continue;
    // Of TetGen's pairs one is listed.
    auto other = path;
    other.replace_extension(path.extension() == ".node" ? ".ele" : ".node");
    EXPECT_TRUE(messages.count(path.filename()) || messages.count(other.filename())) << path;
  }
}

/// Whatever is cut off or changed in a good file: an answer or an InvalidInput.
void survive(const std::string& content, const std::string& name) {
  try {
    const MeshFile file = read_mesh(content, name, [](const std::string&) { return ""; });
    if (const auto* surface = std::get_if<SurfaceFile>(&file))
      require_valid(surface->mesh, surface->lines);
  } catch (const InvalidInput&) {
  }
}

TEST(MeshingBroken, CutAndChangedFilesAreSurvived) {
  for (const char* name :
       {"touching.off", "open-edge.obj", "open-edge.stl", "nan-binary.stl", "fraction.ply",
        "cut-binary.ply", "overlap.mesh", "wrong-index.vtk", "wrong-index.msh"}) {
    const std::string good = content_of(kFolder + name);
    for (std::size_t i = 0; i < good.size(); ++i) {
      survive(good.substr(0, i), name);
      std::string changed = good;
      for (const char c : {'0', '9', '-', ' ', '\n', '\xff', '\0'}) {
        changed[i] = c;
        survive(changed, name);
      }
    }
  }
}

}  // namespace
}  // namespace tripus::meshing
