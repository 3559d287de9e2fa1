// tripus draw: a planar diagram as a picture, or as a drawing in space.
#include <memory>
#include <optional>

#include "base/output_file.hpp"
#include "cli/failure.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/verb.hpp"
#include "drawing/drawing.hpp"
#include "manifold/load_diagram.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kDrawHelp =
    "DIAGRAM is a name of the tables (hk6_9, 8_19, '5_1 theta'), a diagram as it is written\n"
    "(PD: V[1,6,11] X[1,9,2,10] ...), or a file with one, or -: docs/diagrams.md has the forms.\n"
    "\n"
    "The picture is made of arcs of circles, by a circle packing: strands meet nowhere but at\n"
    "crossings. --polylines gives the same in space, as `tripus tube` reads it.\n"
    "\n"
    "Examples:\n"
    "  tripus draw hk6_9 -o hk6_9.svg\n"
    "  tripus draw '5_1 theta' --polylines -o theta.json\n"
    "\n"
    "Exit status: 0 drawn, 2 bad usage or bad input, 3 a failure of the program itself.";

struct DrawCommand {
  std::string diagram, output = "-";
  double size = 320;
  bool polylines = false, black = false, text = false, arcs = false;
};

int run(const DrawCommand& command) {
  if (command.output != "-") {
    const bool is_picture = !command.text && !command.polylines;
    if (is_picture && !command.output.ends_with(".svg") && !command.output.starts_with("/dev/"))
      throw InvalidInput("-o " + tripus::quoted(command.output) +
                         ": the picture is SVG; give it a name that ends with .svg");
    declare_output("-o", command.output);
  }
  require_not_written(command.diagram);
  const topology::NamedDiagram loaded = load_diagram(command.diagram);
  std::optional<OutputFile> file;
  if (command.output != "-") file.emplace(command.output);
  drawing::SvgOptions options;
  options.size = command.size;
  options.title = loaded.name;
  options.colours = !command.black;
  options.arcs = command.arcs;
  const std::string content = command.text        ? topology::pd_text(loaded) + "\n"
                              : command.polylines ? drawing::to_polylines(loaded.diagram)
                                                  : drawing::to_svg(loaded.diagram, options);
  if (file) {
    file->open() << content;
    file->close();
  } else {
    write_output(content);
  }
  return kSuccess;
}

void add_draw(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<DrawCommand>();
  verb->add_option("DIAGRAM", command->diagram, "a name of the tables, a diagram, a file, or -")
      ->option_text(" ")
      ->required();
  verb->add_option("-o,--output", command->output, "file to write (default: standard output)")
      ->option_text("FILE");
  verb->add_option("--size", command->size, "length of the longer side in pixels (default: 320)")
      ->option_text("X")
      ->check(positive_number());
  verb->add_flag("--black", command->black, "all strands black");
  auto* arcs = verb->add_flag("--arcs", command->arcs,
                              "with the numbers of the arcs, as --pd and Cone[ARC,ORDER] name them")
                   ->option_text(" ");
  auto* polylines = verb->add_flag("--polylines", command->polylines,
                                   "not a picture but the drawing in space, for `tripus tube`")
                        ->option_text(" ")
                        ->excludes(arcs);
  verb->add_flag("--pd", command->text, "not a picture but the diagram as PD text")
      ->option_text(" ")
      ->excludes(polylines)
      ->excludes(arcs);
  verb->footer(kDrawHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> draw() {
  static constexpr Verb kRows[] = {{"draw", "picture of a planar diagram", add_draw, 20}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
