// tripus embed: the metric in hyperbolic space, its gluings, its universal cover.
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/metric.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "cli/verb.hpp"
#include "embedding/developing_map.hpp"
#include "embedding/export/circle_svg.hpp"
#include "embedding/export/mesh_formats.hpp"

namespace tripus::cli {
namespace {

struct EmbedCommand {
  CommonOptions common;
  std::string output;
  std::string circles;
  std::size_t cells = 0;  ///< 0: not given
  int depth = -1;         ///< -1: not given
  double radius = 0;      ///< 0: not given
  double area = 0;        ///< of horospheres; 0: not given
  std::string model = "ball";
  MetricSearch search;
  double error = embedding::TessellationOptions{}.error;
};

/// What a file's name asks for: json, svg or a mesh format.
std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

const embedding::CellFormat* find_mesh_format(std::string path) {
  for (char& c : path) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const embedding::CellFormat& format : embedding::mesh_formats())
    if (path.ends_with(fmt::format(".{}", format.extension))) return &format;
  return nullptr;
}

/// The format goes by the ending of the name.
std::vector<std::string> known_endings() {
  std::vector<std::string> known{".json"};
  for (const embedding::CellFormat& format : embedding::mesh_formats())
    known.push_back(fmt::format(".{}", format.extension));
  known.emplace_back(".svg");
  return known;
}

geometry::Model model_named(std::string_view name) {
  for (const auto model : {geometry::Model::kUpperHalfSpace, geometry::Model::kPoincareBall})
    if (to_string(model) == name) return model;
  return geometry::Model::kKleinBall;
}

/// The cells that were asked for; the fundamental domain if nothing was.
embedding::UniversalCover cells_of(const EmbedCommand& command, const Subject& subject,
                                   const embedding::Embedding& embedded) {
  if (command.cells == 0 && command.depth < 0 && command.radius == 0)
    return {embedding::fundamental_domain(embedded, subject.triangulation.gluings()), {}};
  embedding::UniversalCoverOptions options;
  if (command.cells > 0) options.max_cells = command.cells;
  if (command.depth >= 0) options.max_depth = static_cast<std::uint32_t>(command.depth);
  if (command.radius > 0) options.max_radius = command.radius;
  options.stop = &stop_flag();
  embedding::UniversalCover cover =
      embedding::grow_universal_cover(embedded, subject.triangulation, options);
  // All the cells that were asked for are there: nothing ended early.
  if (command.cells > 0 && cover.end == embedding::CoverEnd::kCells)
    cover.end = embedding::CoverEnd::kComplete;
  return cover;
}

/// Ctrl-C leaves fewer cells, in the file and in the answer. One that came before, while the cells
/// were found, has done its work: what was found is written.
void write_mesh(const EmbedCommand& command, EmbeddedSubject& embedded,
                const embedding::CellFormat& format, OutputFile& file) {
  const embedding::Tessellation tessellation(
      embedded.embedding, embedded.cover.cells,
      {model_named(command.model), command.error, stop_flag() ? nullptr : &stop_flag()});
  if (tessellation.triangle_count() > embedding::kMostTriangles) {
    throw InvalidInput(fmt::format(
        "{} cells with an error of {} take {} triangles, more than {}; ask for fewer cells or a "
        "larger --tessellation",
        embedded.cover.cells.size(), command.error, tessellation.triangle_count(),
        embedding::kMostTriangles));
  }
  const std::size_t written = format.write(file.open(), tessellation);
  if (written < embedded.cover.cells.size()) {
    embedded.cover.cells.resize(written);
    embedded.cover.end = embedding::CoverEnd::kInterrupted;
  }
}

/// The paper's circles are those of truncating planes.
void require_circles(const embedding::Embedding& embedded) {
  for (const embedding::HyperboloidTetrahedron& tetrahedron : embedded.tetrahedra)
    if (tetrahedron.diagonal != embedding::HyperboloidTetrahedron{}.diagonal ||
        tetrahedron.parabolic_edges != 0)
      throw Unsupported(
          "circles at infinity are drawn for geodesic boundary only, not for cusps, finite "
          "vertices "
          "and parabolic edges; write .json or a surface, such as .ply");
}

std::string circle_figure(const EmbeddedSubject& embedded) {
  return embedding::circles_as_svg(
      embedding::circle_pictures(embedded.embedding, embedded.cover.cells,
                                 embedded.report.dihedral_angles),
      fmt::format("circles of {}: {}", printable(embedded.subject.input),
                  counted(embedded.cover.cells.size(), "cell", "cells")));
}

void write_embedding(const EmbedCommand& command, EmbeddedSubject& embedded, OutputFile& file) {
  const std::string extension = extension_of(file.path());
  if (const embedding::CellFormat* format = find_mesh_format(file.path())) {
    write_mesh(command, embedded, *format, file);
  } else if (extension == "svg") {
    file.open() << circle_figure(embedded);
  } else {
    file.open() << embedding_as_json(embedded) << '\n';
  }
  file.close();
}

Reply embed_one(const EmbedCommand& command, const std::string& input) {
  std::optional<OutputFile> file, circles;
  if (!command.output.empty()) file.emplace(command.output);
  if (!command.circles.empty()) circles.emplace(command.circles);
  Subject loaded = load_ideal_subject(input, Balls::kRefused, interruptible(), require_with_remedy);
  const Solved solved = find_metric(std::move(loaded), {}, command.search);
  const Subject& subject = solved.subject;
  const structure::Report& report = solved.report;
  const bool wants_json = command.common.json || command.output.empty();
  const char* const line_end = command.common.json ? "" : "\n";  // --json adds it by itself
  if (!solved.is_geometric()) {
    return {wants_json
                ? report_as_json(subject, report, solved.search()) + line_end
                : report_as_text(subject, report, solved.search()) + "  nothing was embedded\n",
            kNoAnswer};
  }
  embedding::Embedding placed = embedding::embed(subject.triangulation, report.edge_lengths,
                                                 {subject.cone_angles, command.area});
  if (command.area > 0 && placed.horosphere_area == 0)
    throw InvalidInput("--horosphere-area: " + tripus::quoted(subject.input) +
                       " has no cusp, and so no horosphere; leave the option out");
  if (circles || (file && extension_of(file->path()) == "svg")) require_circles(placed);
  embedding::UniversalCover cover = cells_of(command, subject, placed);
  EmbeddedSubject embedded{subject, report, std::move(placed), std::move(cover)};
  if (file) write_embedding(command, embedded, *file);
  if (circles) {
    circles->open() << circle_figure(embedded);
    circles->close();
  }
  const int status = embedded.cover.end == embedding::CoverEnd::kComplete ? kSuccess : kNoAnswer;
  if (wants_json) return {embedding_as_json(embedded) + line_end, status};
  return {command.common.quiet ? "" : embedding_as_text(embedded, command.output), status};
}

int run(const EmbedCommand& command) {
  if (!command.output.empty()) declare_output("-o", command.output);
  if (!command.circles.empty()) declare_output("--circles", command.circles);
  return answer_inputs(command.common,
                       [&](const std::string& input) { return embed_one(command, input); });
}

void add_cell_options(CLI::App& verb, EmbedCommand& command) {
  auto* cells = verb.add_option("--cells", command.cells,
                                fmt::format("the first N cells of the universal cover, nearest "
                                            "first (1 to {})",
                                            embedding::kMostCells))
                    ->option_text("N")
                    ->check(CLI::Range(std::size_t{1}, embedding::kMostCells));
  auto* depth = verb.add_option("--depth", command.depth,
                                "the cells that at most D faces part from the first")
                    ->option_text("D")
                    ->check(whole_number(std::numeric_limits<int>::max()));
  verb.add_option("--radius", command.radius,
                  "every cell that comes within the hyperbolic distance R of the\n"
                  "centre of the first")
      ->option_text("R")
      ->check(positive_number())
      ->excludes(cells)
      ->excludes(depth);
  depth->excludes(cells);
}

void add_embed(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<EmbedCommand>();
  verb->add_option("INPUT", command->common.input,
                   "an isomorphism signature, a file, or - for standard input")
      ->option_text(" ")
      ->transform(unshield())
      ->required();
  std::string formats = "write to a file; its name ends in\n.json      as --json prints it\n";
  for (const embedding::CellFormat& format : embedding::mesh_formats())
    formats += fmt::format(".{:<9} {}\n", format.extension, format.summary);
  verb->add_option("-o,--output", command->output,
                   formats + ".svg       the circles at infinity, as --circles")
      ->option_text("FILE")
      ->check(file_name(known_endings()));
  verb->add_flag("--json", command->common.json,
                 "one JSON object on standard output; also without -o");
  verb->add_flag("--quiet", command->common.quiet, "no text about the cells");
  add_cell_options(*verb, *command);
  verb->add_option("--horosphere-area", command->area,
                   "area of the horosphere at which each cusp is cut off (default:\n"
                   "sqrt(3)/2, or less where horoballs would reach opposite faces)")
      ->option_text("A")
      ->check(positive_number());
  add_metric_search(*verb, command->search);
  verb->add_option("--model", command->model, "of surfaces: upper, ball (default) or klein")
      ->option_text("NAME")
      ->check(CLI::IsMember({"upper", "ball", "klein"}));
  verb->add_option("--tessellation", command->error,
                   fmt::format("how far the triangles of surfaces may lie from the curved\n"
                               "faces, in the coordinates of the model (default: {})",
                               command->error))
      ->option_text("X")
      ->check(positive_number());
  verb->add_option("--circles", command->circles,
                   "draw the circles of the cells at infinity, in the paper's place,\nas SVG")
      ->option_text("FILE.svg")
      ->check(file_name({".svg"}));
  verb->footer(
      std::string("Without --cells, --depth or --radius the cells are a fundamental domain: each\n"
                  "tetrahedron once.\n\n") +
      kInputHelp + "\n" + kExitStatusHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> embed() {
  static constexpr Verb kRows[] = {
      {"embed", "tetrahedra in hyperbolic space, their gluings, the universal cover", add_embed,
       15}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
