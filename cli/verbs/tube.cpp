// tripus tube: the boundary surface of a ball or box with the tube around a spatial graph removed.
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/output_file.hpp"
#include "base/stop.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "meshing/formats/read_graph.hpp"
#include "meshing/formats/write_surface.hpp"
#include "meshing/tube/tube_surface.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kGraphHelp =
    "GRAPH is a file (or - for standard input): Geomview's VECT, lines (l) of a Wavefront OBJ, "
    "points\n"
    "as three numbers a line with empty lines between polylines, or JSON:\n"
    "  {\"vertices\": [[x,y,z], ...], \"edges\": [[[x,y,z], ...], ...], \"outer\": ...}\n"
    "Each edge is a list of points. Its ends are vertices; or it ends where it begins, a knot; or "
    "an\n"
    "end goes on to the outer surface, which it must meet within 60 degrees of its normal, and "
    "the\n"
    "tube is open there. \"outer\" is \"automatic\" (a sphere around the graph),\n"
    "{\"sphere\": {\"center\": [x,y,z], \"radius\": r}},\n"
    "{\"box\": {\"low\": [x,y,z], \"high\": [x,y,z]}} or \"none\".\n"
    "\n"
    "The surface bounds the piece of space inside the outer surface and outside the tube; it is\n"
    "closed, manifold and free of self-intersections. Strands that touch are refused, with their\n"
    "place. By itself the tube is made of straight pipes with three sides, each as thick as its\n"
    "surroundings allow, in a few milliseconds. --radius, --triangles and --resolution make a "
    "round\n"
    "tube of one radius; where strands come close, that takes many triangles, and minutes.\n"
    "\n"
    "Examples:\n"
    "  tripus tube examples/graphs/knotted-y.json -o knotted-y.off\n"
    "  tripus tube examples/graphs/knotted-y.json --triangles 3000 -o round.off\n"
    "\n"
    "Exit status: 0 the surface was made, 1 interrupted, 2 bad usage or bad input, 3 a failure of\n"
    "the program itself.";

struct TubeCommand {
  std::string graph, output;
  double radius = 0, around = 0;
  int triangles = 0;
  bool json = false, quiet = false;
};

meshing::TubeOptions options_of(const TubeCommand& command, Progress& progress) {
  meshing::TubeOptions options;
  if (command.radius > 0) options.radius = command.radius;
  if (command.triangles > 0) options.triangles = std::size_t(command.triangles);
  if (command.around > 0) options.edges_around = command.around;
  options.stop = &stop_flag();
  options.progress = [&](std::string_view activity) {
    if (progress.due()) progress.show(std::string(activity));
  };
  return options;
}

/// Errors name the file they come from.
meshing::Tube tube_of(const TubeCommand& command) {
  const std::string text = read_file(command.graph);
  const std::string source =
      command.graph == "-" ? "standard input" : tripus::quoted(command.graph);
  try {
    Progress progress(!command.quiet);
    return meshing::make_tube(meshing::read_graph(text), options_of(command, progress));
  } catch (const Unsupported& error) {
    throw Unsupported(source + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
}

std::string genus_text(long euler_characteristic) {
  return fmt::format("genus {}", (2 - euler_characteristic) / 2);
}

std::string as_text(const std::string& graph, const meshing::Tube& tube) {
  std::vector<std::string> genera;
  for (const long chi : tube.euler_characteristics) genera.push_back(genus_text(chi));
  return fmt::format(
      "{}: {} triangles, {} points, {} component{}: {}\n"
      "tube of radius {}; one radius below {:.6g} has room everywhere: {}\n",
      printable(graph), tube.surface.triangles.size(), tube.surface.points.size(), genera.size(),
      genera.size() == 1 ? "" : "s", fmt::join(genera, ", "),
      tube.thickest > tube.radius ? fmt::format("{:.6g} to {:.6g}", tube.radius, tube.thickest)
                                  : fmt::format("{:.6g}", tube.radius),
      tube.room, tube.room_place);
}

std::string as_json(const TubeCommand& command, const meshing::Tube& tube) {
  JsonText out;
  append_header(out, command.graph);
  append(out, ", \"output\": ");
  append_string(out, command.output);
  append(out, fmt::format(", \"triangle_count\": {}, \"point_count\": {}, \"genera\": [",
                          tube.surface.triangles.size(), tube.surface.points.size()));
  bool first = true;
  for (const long chi : tube.euler_characteristics) {
    append(out, fmt::format("{}{}", first ? "" : ", ", (2 - chi) / 2));
    first = false;
  }
  append(out, "], \"radius\": ");
  append_number(out, tube.radius);
  append(out, ", \"thickest_radius\": ");
  append_number(out, tube.thickest);
  append(out, ", \"largest_radius\": ");
  append_number(out, tube.room);
  append(out, ", \"limited_by\": ");
  append_string(out, tube.room_place);
  append(out, "}\n");
  return fmt::to_string(out);
}

int run(const TubeCommand& command) {
  if (command.json && command.output == "-")
    throw InvalidInput(
        "--json and the surface cannot both go to standard output; name a file "
        "with -o");
  const meshing::SurfaceFormat& format = command.output == "-"
                                             ? meshing::surface_formats().front()
                                             : meshing::surface_format_of(command.output);
  std::optional<OutputFile> file;
  if (command.output != "-") {
    declare_output("-o", command.output);
    file.emplace(command.output);
  }
  require_not_written(command.graph);
  try {
    const meshing::Tube tube = tube_of(command);
    const std::string surface = format.write(tube.surface);
    if (file) {
      file->open() << surface;
      file->close();
    } else {
      write_output(surface);
    }
    if (command.json)
      write_output(as_json(command, tube));
    else if (!command.quiet)
      write_message(as_text(command.graph, tube));
  } catch (const Stopped&) {
    write_message("tripus: " + stop_text() + "; nothing was written\n");
    return kNoAnswer;
  }
  return kSuccess;
}

void add_tube(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<TubeCommand>();
  verb->add_option("GRAPH", command->graph, "file with a graph in space, or -")
      ->option_text(" ")
      ->required();
  verb->add_option("-o,--output", command->output,
                   "file to write, .off, .obj, .ply or .stl, or - (OFF)")
      ->option_text("FILE")
      ->required();
  verb->add_option("--radius", command->radius,
                   "a round tube of this radius (with --triangles or --resolution\n"
                   "alone: half of what the strands leave)")
      ->option_text("X")
      ->check(positive_number());
  auto* triangles =
      verb->add_option("--triangles", command->triangles, "a round tube of about N triangles")
          ->option_text("N")
          ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--resolution", command->around,
                   "a round tube with X triangle edges around it (default: 10)")
      ->option_text("X")
      ->check(positive_number())
      ->excludes(triangles);
  verb->add_flag("--json", command->json, "print one JSON object about the surface");
  verb->add_flag("--quiet", command->quiet, "no text about the surface");
  verb->footer(kGraphHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> tube() {
  static constexpr Verb kRows[] = {
      {"tube", "surface of the tube around a graph in space", add_tube, 19}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
