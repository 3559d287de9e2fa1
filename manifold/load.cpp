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
#include "meshing/manifold.hpp"
#include "topology/isosig.hpp"
#include "topology/requirements.hpp"
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

/// The one triangulation in a text; a list of several belongs to --batch.
topology::NamedGluings read_single(const std::string& text, const std::string& source) {
  return blame(source, [&] {
    const topology::TextFormat format = topology::detect_format(text);
    if (format != topology::TextFormat::kUnknown && format != topology::TextFormat::kIsosig)
      return topology::read_triangulation(text);
    const auto lines = topology::read_batch(text);
    if (lines.size() == 1 && topology::looks_like_isosig(lines.front().text))
      return topology::read_triangulation(lines.front().text);
    if (lines.size() > 1 && topology::looks_like_isosig(lines.front().text)) {
      throw InvalidInput("it holds " + std::to_string(lines.size()) +
                         " inputs; give it to --batch to run them all");
    }
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
enum class Wanted { kAny, kWithMetric };

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
    return {{}, std::move(manifold.gluings), {}};
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

topology::NamedGluings load(const std::string& input, Wanted wanted, const Context& context) {
  if (input.empty()) throw InvalidInput("the input is empty; give a signature or a file");
  std::error_code status;
  if (input == "-" || std::filesystem::exists(input, status)) {
    const std::string content = read_file(input);
    if (auto mesh = read_as_mesh(content, input))
      return solid_of(*std::move(mesh), wanted, source_of(input), context);
    return read_single(content, source_of(input));
  }
  if (topology::looks_like_isosig(input)) return {{}, topology::decode_isosig(input), {}};
  throw InvalidInput(quoted(input) +
                     " is neither a file nor an isomorphism signature (letters, digits, + and -)");
}

void refuse_labels(const topology::NamedGluings& loaded, const std::string& input) {
  if (!topology::all_full(loaded.cone_angles))
    throw Unsupported(source_of(input) +
                      " has singular edges (cone angles other than 2 pi), which only info, solve "
                      "and check know so far");
}

}  // namespace

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
  topology::NamedGluings loaded = load(input, Wanted::kAny, context);
  refuse_labels(loaded, input);
  return loaded;
}

topology::NamedGluings load_solvable_input(const std::string& input, const Context& context) {
  topology::NamedGluings loaded = load(input, Wanted::kWithMetric, context);
  refuse_labels(loaded, input);
  blame(source_of(input),
        [&] { topology::require_geodesic_boundary(topology::Triangulation(loaded.gluings)); });
  return loaded;
}

topology::NamedGluings load_labelled_input(const std::string& input, Balls balls,
                                           const Context& context) {
  return load(input, balls == Balls::kAllowed ? Wanted::kAny : Wanted::kWithMetric, context);
}

std::optional<meshing::MeshFile> load_mesh(const std::string& input) {
  if (input.empty()) throw InvalidInput("the input is empty; give a file");
  return read_as_mesh(read_file(input), input);
}

}  // namespace tripus
