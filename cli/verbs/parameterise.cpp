// tripus parameterise: the harmonic map of a solid onto its hyperbolic manifold.
#include "manifold/parameterise.hpp"

#include <limits>
#include <memory>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "parameterise/refine.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kParameteriseHelp =
    "INPUT is a surface or a tetrahedral mesh, as for tripus mesh. Its solid must carry a metric: "
    "the\n"
    "boundary has a component of genus 2 or more, and no torus. Every point of the mesh gets a "
    "point\n"
    "of hyperbolic space, neighbours up to deck transformations that the topology of the solid "
    "tells,\n"
    "boundary points on the geodesic boundary, such that the energy, the sum of the weighted "
    "squares\n"
    "of distances along edges, is least. With positive weights it has one minimum, which Newton's\n"
    "method finds; with those of finite elements, that next to it. A surface is filled with few\n"
    "tetrahedra by itself; --tetrahedra N makes them smaller, --refine N where the map stretches "
    "them.\n"
    "x.vtu has it all for ParaView, PyVista and tripus view --solid: docs/parameterise.md.\n"
    "\n"
    "Examples:\n"
    "  tripus parameterise examples/surfaces/knotted-y.off -o y.vtu\n"
    "  tripus parameterise mesh.vtk --refine 100000 --report report.html --picture solid.svg\n"
    "\n"
    "Exit status: 0 done, 1 no minimum within the limits, or interrupted, 2 bad usage or bad "
    "input,\n"
    "3 a failure of the program itself.";

struct ParameteriseCommand {
  CommonOptions common;
  ParameteriseOptions options;
  std::string output, report, picture;
  std::string weights = "finite-elements";
  std::string method = "newton";
  double cut_away = 0.5;
};

void declare_outputs(const ParameteriseCommand& command) {
  if (!command.output.empty()) declare_output("-o", command.output);
  if (!command.report.empty()) declare_output("--report", command.report);
  if (!command.picture.empty()) declare_output("--picture", command.picture);
}

std::string as_text(const std::string& input, const Parameterisation& found) {
  std::string text = printable(input) + "\n";
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<14}{}\n", label, value);
  };
  const auto& solid = found.solid();
  const auto& map = found.map();
  const auto& quality = found.quality();
  for (const std::string& note : solid.notes) line("note", note);
  line("solid", fmt::format("{} tetrahedra, {} points, {} edges", solid.mesh.tetrahedra.size(),
                            solid.mesh.points.size(), found.edge_count()));
  line("manifold",
       fmt::format("{}, volume {:.12g}",
                   counted(solid.manifold->tetrahedron_count(), "tetrahedron", "tetrahedra"),
                   quality.manifold_volume));
  line("marking", fmt::format("{} steps taken back; relators hold to {:.1e}", solid.steps,
                              found.relator_defect()));
  if (found.clipped_weights() > 0)
    line("weights", fmt::format("{} of {} raised to be positive", found.clipped_weights(),
                                found.edge_count()));
  line("energy", fmt::format("{:.12g}, max|gradient| {:.1e}: {} after {} steps", map.energy,
                             map.max_gradient, solver::to_string(map.termination), map.iterations));
  if (const std::string advice = found.advice(); !advice.empty()) line("advice", advice);
  line("image", fmt::format("volume {:.12g}, {} turned over, {} flat", quality.image_volume,
                            quality.inverted, quality.flat));
  line("distortion", fmt::format("median anisotropy {:.4g}", quality.median_anisotropy));
  return text;
}

Reply parameterise_one(const ParameteriseCommand& command, const std::string& input) {
  Progress progress(!command.common.quiet && command.common.batch.empty());
  Context context = interruptible();
  context.progress = [&](std::string_view activity, std::size_t tetrahedra) {
    if (!progress.due()) return;
    progress.show(tetrahedra == 0 ? fmt::format("{}", activity)
                                  : fmt::format("{}: {}", activity, tetrahedra));
  };
  const Parameterisation found = parameterise_solid(input, command.options, context);
  if (!command.output.empty()) write_file(command.output, found.to_vtu());
  if (!command.report.empty()) write_file(command.report, found.to_page());
  if (!command.picture.empty()) write_file(command.picture, found.to_svg(command.cut_away));
  return {command.common.json ? found.to_json() : as_text(input, found),
          found.converged() ? kSuccess : kNoAnswer};
}

int run(ParameteriseCommand& command) {
  declare_outputs(command);
  command.options.weights = parameterise::weights_of(command.weights);
  command.options.map.minimiser = command.method == "ceres"     ? parameterise::Minimiser::kCeres
                                  : command.method == "descent" ? parameterise::Minimiser::kDescent
                                                                : parameterise::Minimiser::kNewton;
  return answer_inputs(command.common,
                       [&](const std::string& input) { return parameterise_one(command, input); });
}

void add_parameterise(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<ParameteriseCommand>();
  add_common_options(*verb, command->common);
  CLI::Option* batch = verb->get_option("--batch");
  verb->add_option("-o,--output", command->output, "write the map: x.vtu (VTK)")
      ->option_text("FILE")
      ->check(file_name({".vtu"}))
      ->excludes(batch);
  verb->add_option("--report", command->report, "write a page with pictures: x.html")
      ->option_text("FILE")
      ->check(file_name({".html"}))
      ->excludes(batch);
  CLI::Option* picture =
      verb->add_option("--picture", command->picture,
                       "draw the solid, in the colours of the manifold's\ntetrahedra: x.svg")
          ->option_text("FILE")
          ->check(file_name({".svg"}))
          ->excludes(batch);
  verb->add_option("--cut-away", command->cut_away,
                   "cut away this part of the solid in the picture, 0 to 1\n(default: 0.5)")
      ->option_text("X")
      ->check(CLI::Validator(
          [](std::string& text) {
            const auto part = parse_number(text);  // CLI::Range lets NaN pass
            return part && *part >= 0 && *part <= 1
                       ? std::string()
                       : tripus::quoted(text) + " is not a number from 0 to 1";
          },
          ""))
      ->needs(picture);
  verb->add_option("--weights", command->weights,
                   "of the edges: finite-elements, cotangent (the same, raised where\n"
                   "they are not positive) or uniform (default: finite-elements)")
      ->option_text("NAME")
      ->check(CLI::IsMember({"finite-elements", "cotangent", "uniform"}));
  verb->add_option("--method", command->method,
                   "newton, ceres, or descent, for comparison (default: newton)")
      ->option_text("NAME")
      ->check(CLI::IsMember({"newton", "ceres", "descent"}));
  verb->add_option("--tolerance", command->options.map.tolerance,
                   "on the largest entry of the gradient (default: 1e-11)")
      ->option_text("X")
      ->check(positive_number());
  auto& filling = command->options.marking.tetrahedralize;
  verb->add_option("--tetrahedra", filling.tetrahedra,
                   "fill a surface with about N tetrahedra, more if its triangles\n"
                   "force it (default: as few as it takes, or a quarter of --refine)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--refine", command->options.refine,
                   "then bisect edges that the map makes long, until there are N\n"
                   "tetrahedra (default: none)")
      ->option_text("N")
      ->check(whole_number(parameterise::kMostRefined));
  verb->add_option("--seed", command->options.marking.seed, "of the simplification (default: 0)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->footer(kParameteriseHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> parameterise() {
  static constexpr Verb kRows[] = {{"parameterise",
                                    "the harmonic map of a solid onto its hyperbolic manifold",
                                    add_parameterise, 18}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
