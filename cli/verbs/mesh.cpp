// tripus mesh: from a boundary surface or a tetrahedral mesh to a small ideal triangulation.
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/output_file.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "manifold/load.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/manifold.hpp"
#include "meshing/picture.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kMeshHelp =
    "INPUT is a closed surface (OFF, OBJ, STL, PLY, legacy VTK, VTK XML .vtp and .vtu, Gmsh .msh,\n"
    "Medit .mesh) or a tetrahedral mesh (the last four, TetGen .node and .ele), gzip-compressed "
    "or\n"
    "not, recognised by its content; - for standard input. Polygons are cut into triangles; "
    "points\n"
    "that lie in one place are merged, and cracks and T-junctions as programs leave them are "
    "closed\n"
    "where that closes the surface. What was done is said. Of a\n"
    "surface, the solid is what lies inside the outermost component and outside the others.\n"
    "It is checked first, and what is wrong is named with its place. Then it is filled with\n"
    "tetrahedra (mesh), the boundary is coned off (coned), edges are collapsed until only the\n"
    "cone points are left (collapsed), and moves make it as small as they can (minimal). A\n"
    "boundary component of genus 1 or more becomes an ideal vertex, a sphere is filled in.\n"
    "\n"
    "Exit status: 0 done, 1 the solid is a ball, or interrupted, 2 bad usage or bad input, 3 a\n"
    "failure of the program itself.";

struct MeshCommand {
  CommonOptions common;
  meshing::ManifoldOptions options;
  std::string output;
  std::string mesh_output;
  std::string pictures;
};

bool ends_with(const std::string& path, std::string_view ending) {
  return path.size() > ending.size() && path.ends_with(ending);
}

/// What --pictures adds to its prefix.
constexpr std::array kPictures{"-boundary.svg", "-mesh.svg", "-coned.svg", "-stages.svg"};

/// Before the work, not after it.
void require_known_outputs(const MeshCommand& command) {
  if (!command.output.empty()) require_triangulation_name(command.output);
  if (!command.output.empty()) declare_output("-o", command.output);
  if (!command.mesh_output.empty()) declare_output("--save-mesh", command.mesh_output);
  if (!command.pictures.empty())
    for (const char* ending : kPictures) declare_output("--pictures", command.pictures + ending);
  if (!command.mesh_output.empty() && !ends_with(command.mesh_output, ".vtk") &&
      !ends_with(command.mesh_output, ".mesh") && !ends_with(command.mesh_output, ".msh"))
    throw InvalidInput("--save-mesh " + tripus::quoted(command.mesh_output) +
                       ": the name must end with .vtk, .mesh or .msh");
}

void write_outputs(const MeshCommand& command, const meshing::MeshedManifold& manifold,
                   const Subject& subject) {
  if (!command.mesh_output.empty() && !manifold.mesh_is_exact)
    throw Unsupported(printable(subject.input) +
                      ": the tetrahedra that fill this surface are too thin for doubles, so that "
                      "--save-mesh cannot write them; leave it out, or remesh the surface more "
                      "evenly");
  if (!command.output.empty()) write_triangulation_file(command.output, subject);
  if (ends_with(command.mesh_output, ".vtk"))
    write_file(command.mesh_output, meshing::write_vtk(manifold.mesh));
  if (ends_with(command.mesh_output, ".mesh"))
    write_file(command.mesh_output, meshing::write_medit(manifold.mesh));
  if (ends_with(command.mesh_output, ".msh"))
    write_file(command.mesh_output, meshing::write_gmsh(manifold.mesh));
  if (command.pictures.empty()) return;
  write_file(command.pictures + kPictures[0], meshing::boundary_picture(manifold.mesh));
  write_file(command.pictures + kPictures[1], meshing::cut_picture(manifold.mesh));
  write_file(command.pictures + kPictures[2], meshing::cone_picture(manifold.mesh));
  write_file(command.pictures + kPictures[3], meshing::stages_picture(manifold));
}

/// What became of it, in a sentence.
std::string message_of(const meshing::MeshedManifold& manifold, const Subject& subject) {
  if (manifold.has_only_spheres()) return meshing::ball_message(manifold) + ".";
  return one_line(subject.triangulation) + ".";
}

std::string as_json(const meshing::MeshedManifold& manifold, const Subject& subject) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append_oriented(out, subject);
  auto to = std::back_inserter(out);
  fmt::format_to(to, ", \"points\": {}, \"triangles\": {}, \"turned_triangles\": {}",
                 manifold.points, manifold.triangles, manifold.turned);
  fmt::format_to(to, ", \"boundary_genera\": [{}], \"stages\": {{",
                 fmt::join(manifold.boundary_genera, ", "));
  for (std::size_t i = 0; i < meshing::kStageCount; ++i)
    fmt::format_to(to, "{}\"{}\": {}", i == 0 ? "" : ", ",
                   meshing::stage_name(static_cast<meshing::MeshStage>(i)), manifold.tetrahedra[i]);
  append(out, "}, \"notes\": [");
  for (std::size_t i = 0; i < manifold.notes.size(); ++i) {
    if (i > 0) append(out, ", ");
    append_string(out, manifold.notes[i]);
  }
  append(out, "], \"ball\": ");
  append(out, manifold.has_only_spheres() ? "true" : "false");
  const std::string table = topology::write_json({{}, manifold.gluings});  // {"gluings": ...}
  append(out, ", ");
  append(out, std::string_view(table).substr(1, table.rfind('}') - 1));
  append(out, ", \"message\": ");
  append_string(out, message_of(manifold, subject));
  out.push_back('}');
  return fmt::to_string(out);
}

std::string as_text(const meshing::MeshedManifold& manifold, const Subject& subject) {
  std::string text = printable(subject.input) + "\n";
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<14}{}\n", label, value);
  };
  if (manifold.triangles > 0)
    line("surface",
         fmt::format(
             "{} points, {} triangles{}", manifold.points, manifold.triangles,
             manifold.turned == 0 ? "" : fmt::format(" ({} turned round)", manifold.turned)));
  for (const std::string& note : manifold.notes) line("note", note);
  std::vector<std::string> genera;
  for (const int genus : manifold.boundary_genera)
    genera.push_back(genus == 0 ? "sphere" : fmt::format("genus {}", genus));
  line("boundary", shortened(genera));
  for (std::size_t i = 0; i < meshing::kStageCount; ++i)
    line(meshing::stage_name(static_cast<meshing::MeshStage>(i)),
         counted(manifold.tetrahedra[i], "tetrahedron", "tetrahedra"));
  if (manifold.has_only_spheres()) {
    line("no metric", message_of(manifold, subject));
    return text;
  }
  line("signature", signature_text(subject.isosig));
  if (subject.oriented_isosig) line("oriented", signature_text(subject.oriented_isosig));
  if (const std::string why_not = objection_to(subject.triangulation); !why_not.empty())
    line("not solvable", why_not);
  return text;
}

Reply mesh_one(const MeshCommand& command, const std::string& input) {
  meshing::MeshFile file = load_mesh(input);
  const std::string source = input == "-" ? "standard input" : tripus::quoted(input);
  Progress progress(!command.common.quiet && command.common.batch.empty());
  meshing::ManifoldOptions options = command.options;
  options.stop = &stop_flag();
  // A limit of the user's is the only one; the flag comes first, with its words.
  if (const double left = seconds_left(); std::isfinite(left))
    options.tetrahedralize.time_limit = left + 1;
  options.progress = [&](std::string_view activity, std::size_t tetrahedra) {
    if (!progress.due()) return;
    progress.show(tetrahedra == 0 ? fmt::format("{}", activity)
                                  : fmt::format("{}: {} tetrahedra", activity, tetrahedra));
  };
  meshing::MeshedManifold manifold;
  try {
    manifold = meshing::manifold_of(std::move(file), options);
  } catch (const Unsupported& error) {
    throw Unsupported(source + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
  const Subject subject = make_subject(input, topology::NamedGluings{{}, manifold.gluings});
  write_outputs(command, manifold, subject);
  return {command.common.json ? as_json(manifold, subject) : as_text(manifold, subject),
          manifold.has_only_spheres() ? kNoAnswer : kSuccess};
}

int run(const MeshCommand& command) {
  require_known_outputs(command);
  return answer_inputs(command.common,
                       [&](const std::string& input) { return mesh_one(command, input); });
}

void add_mesh(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<MeshCommand>();
  add_common_options(*verb, command->common);
  auto* output = verb->add_option("-o,--output", command->output,
                                  "write the triangulation: x.json (gluing table), x.sig\n"
                                  "(signature), x.rga (Regina) or x.tri (SnapPea); each is\n"
                                  "an INPUT again")
                     ->option_text("FILE")
                     ->check(problem_of_name);
  auto* mesh_output = verb->add_option("--save-mesh", command->mesh_output,
                                       "write the tetrahedral mesh: x.vtk, x.mesh (Medit) or\n"
                                       "x.msh (Gmsh)")
                          ->option_text("FILE")
                          ->check(problem_of_name);
  output->excludes(verb->get_option("--batch"));
  mesh_output->excludes(verb->get_option("--batch"));
  verb->add_option("--pictures", command->pictures,
                   "draw the stages: PREFIX-boundary.svg, -mesh.svg, -coned.svg,\n"
                   "-stages.svg")
      ->option_text("PREFIX")
      ->check(problem_of_name)
      ->excludes(verb->get_option("--batch"));
  auto& filling = command->options.tetrahedralize;
  auto* aim = verb->add_option("--tetrahedra", filling.tetrahedra,
                               "fill a surface with about N tetrahedra, more if its triangles\n"
                               "force it (default: as few as it takes)")
                  ->option_text("N")
                  ->check(whole_number(std::numeric_limits<int>::max()));
  verb->add_option("--max-volume", filling.max_volume, "no tetrahedron larger than V")
      ->option_text("V")
      ->check(positive_number())
      ->excludes(aim);
  verb->add_option("--seed", command->options.seed, "of the search for fewer (default: 0)")
      ->option_text("N")
      ->check(whole_number(std::numeric_limits<int>::max()));
  verb->footer(kMeshHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> mesh() {
  static constexpr Verb kRows[] = {
      {"mesh", "from a surface or a tetrahedral mesh to a small triangulation", add_mesh, 4}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
