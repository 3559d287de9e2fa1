#include "manifold/load.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "canonical/census.hpp"
#include "manifold/prepared.hpp"
#include "meshing/manifold.hpp"
#include "topology/formats/foreign_names.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

namespace tripus {
namespace {

/// An error in a content, with where it comes from. Keeps apart what is wrong and what is too much.
template <class Work>
auto blame(const std::string& source, Work&& work) {
  try {
    return work();
  } catch (const Unsupported& error) {
    throw Unsupported(source + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
}

/// A manifold of the shipped census by its name. Its triangulation says nothing about orientation.
std::optional<topology::NamedGluings> find_in_census(const std::string& name) {
  if (!canonical::is_census_name(name)) return std::nullopt;
  const canonical::CensusEntry* entry = canonical::shipped_census().find(name);
  if (entry == nullptr) throw InvalidInput("there is no " + name + " in the shipped census");
  return topology::NamedGluings{name, topology::decode_isosig(entry->triangulations.front()),
                                false};
}

/// A signature; what is none but a name of another program is refused by that name.
topology::NamedGluings read_signature(const std::string& text) {
  try {
    return {{}, topology::decode_isosig(text), topology::isosig_sign(text) != 0};
  } catch (const InvalidInput&) {
    if (const auto foreign = topology::foreign_name(text)) throw InvalidInput(*foreign);
    throw;
  }
}

/// What a text is if it is the whole of an input, or a line of a file: a name or a signature.
std::optional<topology::NamedGluings> read_word(const std::string& text) {
  if (auto named = find_in_census(text)) return named;
  if (topology::looks_like_isosig(text)) return read_signature(text);
  if (const auto foreign = topology::foreign_name(text)) throw InvalidInput(*foreign);
  return std::nullopt;
}

/// A drawing of a graph in space, which has the JSON keys of one and no gluings.
bool is_drawing(const std::string& text) {
  const auto has = [&](const char* key) { return text.find(key) != std::string::npos; };
  return has("\"vertices\"") && has("\"edges\"") && !has("\"gluings\"");
}

/// The first line of a text for a message, if it is one for people: no bytes of a binary file.
std::string beginning_of(const std::string& text) {
  std::string line = text.substr(0, text.find('\n')).substr(0, 64);
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  for (const char c : line)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\t') ||
        static_cast<unsigned char>(c) >= 0x7f)
      return {};
  return line.empty() ? "" : ", starting with " + tripus::quoted(line);
}

/// The one triangulation in a text; a list of several belongs to --batch.
topology::NamedGluings read_single(const std::string& text, const std::string& source) {
  return blame(source, [&] {
    const topology::TextFormat format = topology::detect_format(text);
    if (format == topology::TextFormat::kJson && is_drawing(text))
      throw InvalidInput(
          "it is a drawing of a graph in space, and no triangulation: make the surface around it "
          "first "
          "(tripus tube DRAWING -o surface.off), which is an INPUT");
    if (format != topology::TextFormat::kUnknown && format != topology::TextFormat::kIsosig)
      return topology::read_triangulation(text);
    const auto lines = topology::read_batch(text);
    if (lines.size() == 1) {
      if (auto word = read_word(lines.front().text)) {
        if (word->name.empty()) word->name = lines.front().text;
        return *std::move(word);
      }
    }
    if (lines.size() > 1 && topology::looks_like_isosig(lines.front().text)) {
      throw InvalidInput("it holds " + std::to_string(lines.size()) +
                         " inputs; give it to --batch to run them all");
    }
    if (format == topology::TextFormat::kUnknown && !lines.empty()) throw unrecognised(text);
    return topology::read_triangulation(text);
  });
}

std::string source_of(const std::string& input) {
  return input == "-" ? "standard input" : quoted(input);
}

std::optional<meshing::MeshFile> read_as_mesh(const std::string& content,
                                              const std::string& input) {
  if (!meshing::detect_mesh_format(content, input)) return std::nullopt;
  return blame(source_of(input), [&] { return meshing::read_mesh(content, input, read_file); });
}

/// Which manifolds an INPUT may be.
enum class Wanted { kAny, kManifold, kWithMetric };

topology::NamedGluings solid_of(meshing::MeshFile file, Wanted wanted, const std::string& source,
                                const Context& context) {
  return blame(source, [&]() -> topology::NamedGluings {
    context.report("read");
    const StopFlag stop(context);
    meshing::ManifoldOptions options;
    options.stop_requested = stop.get();
    options.progress = context.progress;
    meshing::Manifold manifold = meshing::manifold_of(std::move(file), options);
    if (wanted == Wanted::kWithMetric && manifold.has_only_spheres())
      throw InvalidInput(meshing::ball_message(manifold));
    return {{}, std::move(manifold.gluings)};
  });
}

/// Enough for ten million tetrahedra in any format; some files, such as /dev/zero, have no end.
constexpr std::size_t kLargestInput = std::size_t{1} << 30;

std::string read_all(std::istream& in, const std::string& source) {
  std::string content;
  std::vector<char> block(1 << 16);
  while (in.read(block.data(), std::ptrdiff_t(block.size())) || in.gcount() > 0) {
    content.append(block.data(), std::size_t(in.gcount()));
    if (content.size() > kLargestInput) throw InvalidInput(source + " is longer than 1 GiB");
  }
  if (in.bad()) throw InvalidInput("cannot read " + source + ": " + std::strerror(errno));
  return content;
}

topology::NamedGluings load_as_given(const std::string& input, Wanted wanted,
                                     const Context& context) {
  if (input.empty()) throw InvalidInput("the input is empty; give a signature or a file");
  std::error_code status;
  if (input == "-" || std::filesystem::exists(input, status)) {
    const std::string content = read_file(input);
    if (auto mesh = read_as_mesh(content, input))
      return solid_of(*std::move(mesh), wanted, source_of(input), context);
    return read_single(content, source_of(input));
  }
  if (auto word = read_word(input)) return *std::move(word);
  throw InvalidInput(
      quoted(input) +
      " is neither a file nor an isomorphism signature (letters, digits, + and -) nor "
      "a name of the census");
}

topology::NamedGluings load(const std::string& input, Wanted wanted, const Context& context) {
  topology::NamedGluings loaded = load_as_given(input, wanted, context);
  const StopFlag stop(context);
  blame(source_of(input), [&] {
    make_ideal(loaded,
               wanted == Wanted::kAny ? topology::FiniteVertices::kKeep
                                      : topology::FiniteVertices::kRemove,
               stop.get());
  });
  return loaded;
}

}  // namespace

InvalidInput unrecognised(const std::string& content) {
  return InvalidInput(
      "unrecognised input" + beginning_of(content) +
      "; looked for a signature, a name of the census, a gluing table (JSON, Regina, SnapPea), a "
      "surface (OFF, OBJ, STL, PLY) and a tetrahedral mesh (Medit, VTK, TetGen)");
}

std::string read_file(const std::string& path) {
  if (path == "-") return read_all(std::cin, "standard input");
  std::error_code status;
  if (std::filesystem::is_directory(path, status))
    throw InvalidInput(quoted(path) + " is a folder; name a file in it");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput("cannot open " + quoted(path) + ": " + std::strerror(errno));
  return read_all(file, quoted(path));
}

topology::NamedGluings load_input(const std::string& input, const Context& context) {
  return load(input, Wanted::kAny, context);
}

topology::NamedGluings load_manifold_input(const std::string& input, const Context& context) {
  return load(input, Wanted::kManifold, context);
}

topology::NamedGluings load_unconed_input(const std::string& input, const Context& context) {
  return load_as_given(input, Wanted::kAny, context);
}

topology::NamedGluings load_solvable_input(const std::string& input, const Context& context,
                                           const Requirement& require) {
  topology::NamedGluings loaded = load(input, Wanted::kWithMetric, context);
  blame(source_of(input), [&] { require(topology::Triangulation(loaded.gluings)); });
  return loaded;
}

std::optional<meshing::MeshFile> load_mesh(const std::string& input) {
  if (input.empty()) throw InvalidInput("the input is empty; give a file");
  const std::string content = read_file(input);
  auto mesh = read_as_mesh(content, input);
  if (!mesh) (void)read_single(content, source_of(input));  // what is no triangulation either
  return mesh;
}

}  // namespace tripus
