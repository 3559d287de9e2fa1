#include "manifold/load.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <utility>
#include <vector>

#include "base/binary.hpp"
#include "base/compression.hpp"
#include "base/error.hpp"
#include "base/system_error.hpp"
#include "canonical/census.hpp"
#include "manifold/labels.hpp"
#include "manifold/load_diagram.hpp"
#include "manifold/prepared.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/manifold.hpp"
#include "topology/diagrams/read_diagram.hpp"
#include "topology/diagrams/small_exterior.hpp"
#include "topology/diagrams/tables.hpp"
#include "topology/formats/formats.hpp"
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

/// A manifold of the shipped census by its name. Its triangulation says nothing about orientation.
std::optional<topology::NamedGluings> find_in_census(const std::string& name) {
  if (!canonical::is_census_name(name)) return std::nullopt;
  const canonical::CensusEntry* entry = canonical::shipped_census().find(name);
  if (entry == nullptr) throw InvalidInput("there is no " + name + " in the shipped census");
  topology::NamedGluings found{name, topology::decode_isosig(entry->triangulations.front())};
  found.orientation_known = false;
  return found;
}

/// A signature; what is none but a name of another program is refused by that name.
topology::NamedGluings read_signature(const std::string& text) {
  try {
    return topology::read_signature(text);
  } catch (const InvalidInput& error) {
    if (const auto foreign = topology::foreign_name(text)) throw InvalidInput(*foreign);
    if (text.find_first_of("./") == std::string::npos) throw;
    throw UnusableFile("there is no file " + quoted(text) +
                       ", and it is no signature: " + error.what());
  }
}

bool is_signature(const std::string& text) {
  try {
    topology::read_signature(text);
    return true;
  } catch (const Error&) {
    return false;
  }
}

topology::NamedGluings exterior_of(const topology::NamedDiagram& diagram, const Context& context) {
  topology::SimplifyOptions options;
  options.stop = context.stop;
  return topology::small_exterior(diagram, options);
}

/// A knot, link or graph of the shipped tables by its name.
std::optional<topology::NamedGluings> find_in_tables(const std::string& name,
                                                     const Context& context) {
  const auto found = topology::find_diagram_or_mirror(name);
  return found ? std::optional(exterior_of(*found, context)) : std::nullopt;
}

[[noreturn]] void refuse_unknown_name(const std::string& name) {
  const auto foreign = topology::foreign_name(name);
  throw InvalidInput("there is no " + quoted(name) +
                     " in the tables that come with the program (tripus table lists them); the "
                     "nearest names there are " +
                     topology::nearest_diagram_names(name) + (foreign ? ". " + *foreign : ""));
}

/// What a text is if it is the whole of an input, or a line of a file: a diagram, a name or a
/// signature.
std::optional<topology::NamedGluings> read_word(const std::string& text, const Context& context) {
  if (auto named = find_in_census(text)) return named;
  if (auto named = find_in_tables(text, context)) return named;
  if (topology::looks_like_diagram(text)) return exterior_of(topology::read_diagram(text), context);
  if (topology::find_diagram_or_mirror(text + ")"))
    throw InvalidInput("the bracket in " + quoted(text) + " is not closed; add ) at the end");
  if (topology::is_diagram_name(text)) refuse_unknown_name(text);
  if (topology::looks_like_signature(text)) return read_signature(text);
  if (const auto foreign = topology::foreign_name(text)) throw InvalidInput(*foreign);
  return std::nullopt;
}

/// A drawing of a graph in space, which has the JSON keys of one and no gluings.
bool is_drawing(const std::string& text) {
  const auto has = [&](const char* key) { return text.find(key) != std::string::npos; };
  return has("\"vertices\"") && has("\"edges\"") && !has("\"gluings\"");
}

[[noreturn]] void refuse_drawing() {
  throw InvalidInput(
      "it is a drawing of a graph in space, and no triangulation: make the surface around it first "
      "(tripus tube DRAWING -o surface.off), which is an INPUT");
}

/// What every verb says of a content that has no format.
[[noreturn]] void refuse_unknown() {
  throw InvalidInput("its content has no format that is known; looked for: " +
                     topology::format_names() + "; " + topology::diagram_format_names() + "; " +
                     meshing::mesh_format_names() + "; a name of the census or of a table");
}

/// What is a mesh in a format that is not read.
void refuse_foreign_mesh(const std::string& content) {
  if (const auto foreign = meshing::foreign_mesh(content)) throw InvalidInput(*foreign);
}

/// The triangulations in a text; a list of several signatures belongs to --batch.
std::vector<topology::NamedGluings> read_all_of(const std::string& text, const Context& context) {
  const auto one = [](topology::NamedGluings each) {
    std::vector<topology::NamedGluings> all;
    all.push_back(std::move(each));
    return all;
  };
  refuse_foreign_mesh(text);
  if (topology::looks_like_diagram(text))
    return one(exterior_of(topology::read_diagram(text), context));
  const std::string_view format = topology::detect_format(text);
  if (format == topology::kJson && is_drawing(text)) refuse_drawing();
  if (format.empty() || format == topology::kIsomorphismSignature) {
    const auto lines = topology::read_batch(text);
    if (lines.size() == 1) {
      if (auto word = read_word(lines.front().text, context)) return one(*std::move(word));
    }
    if (lines.size() > 1 && is_signature(lines.front().text)) {
      throw InvalidInput("it holds " + std::to_string(lines.size()) +
                         " inputs; give it to --batch to run them all");
    }
    if (!lines.empty() && format.empty()) refuse_unknown();
  }
  return topology::read_triangulations(text);
}

/// The one triangulation in a text, or the one with the label.
topology::NamedGluings read_single(const std::string& text, const std::string& source,
                                   const std::optional<std::string>& label,
                                   const Context& context) {
  return blame(source, [&] {
    auto all = read_all_of(text, context);
    if (label) return topology::pick_triangulation(std::move(all), *label);
    if (all.size() == 1) return std::move(all.front());
    throw InvalidInput("it holds " + std::to_string(all.size()) +
                       " triangulations, with the labels " + topology::label_list(all) +
                       "; choose one as FILE#LABEL or FILE#NUMBER, or give the file to --batch to "
                       "run them all");
  });
}

std::string source_of(const std::string& input) {
  return input == "-" ? "standard input" : quoted(input);
}

std::optional<meshing::MeshFile> read_as_mesh(const std::string& content,
                                              const std::string& input) {
  if (!topology::looks_like_diagram(content) && meshing::is_drawn_graph(content))
    blame(source_of(input), refuse_drawing);
  if (!meshing::detect_mesh_format(content, input)) return std::nullopt;
  return blame(source_of(input), [&] { return meshing::read_mesh(content, input, read_file); });
}

/// Which manifolds an INPUT may be.
enum class Wanted { kAny, kManifold, kWithMetric };

topology::NamedGluings solid_of(meshing::MeshFile file, Wanted wanted, const std::string& source,
                                const Context& context) {
  return blame(source, [&]() -> topology::NamedGluings {
    context.report("read");
    meshing::ManifoldOptions options;
    options.stop = context.stop;
    options.progress = context.progress;
    meshing::MeshedManifold manifold = meshing::manifold_of(std::move(file), options);
    if (wanted == Wanted::kWithMetric && manifold.has_only_spheres())
      throw InvalidInput(meshing::ball_message(manifold));
    return {{}, std::move(manifold.gluings), {}, std::move(manifold.notes)};
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
  if (in.bad()) throw UnusableFile("cannot read " + source + ": " + std::strerror(errno));
  return content;
}

/// Decompressed, if it is gzip's.
std::string unpacked(std::string content, const std::string& source) {
  if (!is_gzip(content)) return content;
  return blame(source, [&] { return gunzip(content, kLargestInput); });
}

/// A file, perhaps with the label of a triangulation in it.
struct Place {
  std::string file;
  std::optional<std::string> label;
};

/// The input itself if there is such a file; else what stands before a # if that is one.
std::optional<Place> find_file(const std::string& input) {
  std::error_code status;
  if (input == "-" || std::filesystem::exists(input, status)) return Place{input, std::nullopt};
  for (std::size_t mark = input.find('#'); mark != std::string::npos;
       mark = input.find('#', mark + 1))
    if (const std::string file = input.substr(0, mark); std::filesystem::exists(file, status))
      return Place{file, input.substr(mark + 1)};
  return std::nullopt;
}

topology::NamedGluings load_as_given(const std::string& input, Wanted wanted,
                                     const Context& context) {
  if (input.empty()) throw InvalidInput("the input is empty; give a signature or a file");
  if (const auto place = find_file(input)) {
    const std::string content = read_file(place->file);
    if (!place->label)
      if (auto mesh = read_as_mesh(content, input))
        return solid_of(*std::move(mesh), wanted, source_of(input), context);
    return read_single(content, source_of(place->file), place->label, context);
  }
  if (auto word = read_word(input, context)) {
    const bool is_name =
        canonical::is_census_name(input) || topology::find_diagram_or_mirror(input);
    if (!is_name && !topology::looks_like_diagram(input)) word->name.clear();  // a signature
    return *std::move(word);
  }
  if (topology::is_nearly_diagram_name(input)) refuse_unknown_name(input);
  const std::string message =
      quoted(input) +
      " is neither a file nor an isomorphism signature (letters, digits, + and -) nor "
      "a diagram (PD: X[4,2,5,1] ...) nor a name of the census or of a table";
  if (input.find('/') != std::string::npos) throw UnusableFile(message);
  throw InvalidInput(message);
}

topology::NamedGluings load(const std::string& input, Wanted wanted,
                            topology::FiniteVertices finite_vertices, const Context& context) {
  const auto [plain, labels] = split_labels(input);
  topology::NamedGluings loaded = load_as_given(plain, wanted, context);
  blame(source_of(plain), [&] { make_ideal(loaded, finite_vertices, context.stop); });
  if (!labels.empty())
    loaded.cone_angles = labelled(std::move(loaded.cone_angles),
                                  topology::Triangulation(loaded.gluings).edge_count(), labels);
  return loaded;
}

void refuse_labels(const topology::NamedGluings& loaded, const std::string& input) {
  if (!topology::all_full(loaded.cone_angles) || !split_labels(input).second.empty())
    throw Unsupported(source_of(input) +
                      " has singular edges (cone angles other than 2 pi), which only info, solve, "
                      "check, prove, canonize, compare and identify know so far");
}

void tell_notes(const topology::NamedGluings& loaded, const std::string& input,
                const Context& context) {
  if (!context.note) return;
  for (const std::string& note : loaded.notes) context.note(source_of(input) + ": " + note);
}

/// A list of inputs is text, and no mesh.
void require_list(const std::string& content, const std::string& path) {
  const auto mesh = meshing::detect_mesh_format(content, path);
  if (mesh)
    throw InvalidInput("it is a mesh (" + std::string(*mesh) +
                       ") and no list; write its name on a line of one");
  refuse_foreign_mesh(content);
  if (is_binary(content))
    throw InvalidInput("it is a binary file and no list of inputs, one a line");
}

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") return unpacked(read_all(std::cin, "standard input"), "standard input");
  std::error_code status;
  if (std::filesystem::is_directory(path, status))
    throw UnusableFile(quoted(path) + " is a folder; name a file in it");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UnusableFile("cannot open " + quoted(path) + ": " + std::strerror(errno));
  return unpacked(read_all(file, quoted(path)), quoted(path));
}

std::vector<topology::BatchLine> read_batch_file(const std::string& path) {
  const std::string content = read_file(path);
  blame(source_of(path), [&] { require_list(content, path); });
  if (topology::detect_format(content) != topology::kReginaDataFile)
    return topology::read_batch(content);
  if (path == "-")
    throw InvalidInput("standard input holds a Regina data file; name the file after --batch");
  const auto all = blame(quoted(path), [&] { return topology::read_triangulations(content); });
  std::vector<topology::BatchLine> lines;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto same = [&](const topology::NamedGluings& each) { return each.name == all[i].name; };
    const bool is_label = !all[i].name.empty() && std::count_if(all.begin(), all.end(), same) == 1;
    lines.push_back({i + 1, path + "#" + (is_label ? all[i].name : std::to_string(i + 1))});
  }
  return lines;
}

topology::NamedGluings load_input(const std::string& input, const Context& context) {
  topology::NamedGluings loaded =
      load(input, Wanted::kAny, topology::FiniteVertices::kKeep, context);
  refuse_labels(loaded, input);
  tell_notes(loaded, input, context);
  return loaded;
}

topology::NamedGluings load_manifold_input(const std::string& input, const Context& context) {
  topology::NamedGluings loaded =
      load(input, Wanted::kManifold, topology::FiniteVertices::kRemove, context);
  refuse_labels(loaded, input);
  tell_notes(loaded, input, context);
  return loaded;
}

topology::NamedGluings load_unconed_input(const std::string& input, const Context& context) {
  topology::NamedGluings loaded = load_as_given(split_labels(input).first, Wanted::kAny, context);
  refuse_labels(loaded, input);
  tell_notes(loaded, input, context);
  return loaded;
}

topology::NamedGluings load_solvable_input(const std::string& input, const Context& context,
                                           const Requirement& require) {
  topology::NamedGluings loaded =
      load(input, Wanted::kWithMetric, topology::FiniteVertices::kRemove, context);
  refuse_labels(loaded, input);
  blame(source_of(input), [&] { require(topology::Triangulation(loaded.gluings)); });
  tell_notes(loaded, input, context);
  return loaded;
}

topology::NamedGluings load_labelled_input(const std::string& input, Balls balls,
                                           const Context& context) {
  topology::NamedGluings loaded =
      load(input, balls == Balls::kAllowed ? Wanted::kAny : Wanted::kWithMetric,
           topology::FiniteVertices::kKeep, context);
  tell_notes(loaded, input, context);
  return loaded;
}

topology::NamedDiagram load_diagram(const std::string& input) {
  const auto read = [](const std::string& text) -> topology::NamedDiagram {
    const auto lines = topology::read_batch(text);
    if (lines.size() == 1)
      if (auto tabled = topology::find_diagram_or_mirror(lines.front().text)) return *tabled;
    return topology::read_diagram(text);
  };
  if (const auto place = find_file(input); place && !place->label) {
    const std::string content = read_file(place->file);
    return blame(source_of(input), [&] { return read(content); });
  }
  const bool is_tabled = topology::find_diagram_or_mirror(input).has_value();
  const bool is_known = is_tabled || topology::looks_like_diagram(input);
  if (!is_known && (topology::is_diagram_name(input) || topology::is_nearly_diagram_name(input)))
    refuse_unknown_name(input);
  if (!is_known)
    throw InvalidInput(quoted(input) +
                       " is no diagram: give one as PD: X[4,2,5,1] ..., a file with one, or a name "
                       "of the tables (tripus table lists them)");
  return read(input);
}

meshing::MeshFile load_mesh(const std::string& input) {
  if (input.empty()) throw InvalidInput("the input is empty; give a file");
  const std::string content = read_file(input);
  if (auto mesh = read_as_mesh(content, input)) return *std::move(mesh);
  return blame(source_of(input), [&]() -> meshing::MeshFile {
    refuse_foreign_mesh(content);
    const std::string_view format = topology::detect_format(content);
    if (format.empty() || format == topology::kJson)
      (void)read_all_of(content, {});  // says what it is, if it is no triangulation either
    throw InvalidInput("it is a triangulation (" + std::string(format) + ") and no mesh");
  });
}

}  // namespace tripus
