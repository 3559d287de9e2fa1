// tripus view: see the universal cover, in a window, as a picture, or as a page for a browser.
#include <algorithm>
#include <cctype>
#include <cstring>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "base/stop.hpp"
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
#include "cli/view_numbers.hpp"
#include "cli/view_pages.hpp"
#include "embedding/universal_cover.hpp"
#include "manifold/labels.hpp"
#include "manifold/load.hpp"
#include "parameterise/picture.hpp"
#include "viewer/egl/offscreen.hpp"
#include "viewer/scene_words.hpp"
#include "viewer/window/window.hpp"

namespace tripus::cli {
namespace {

struct ViewCommand {
  CommonOptions common;
  std::string png;
  std::string page;  ///< -o
  std::string solid;
  std::string size = "1200x900";
  std::string camera;
  std::string model = "ball";
  MetricSearch search;
  std::vector<std::string> cone_orders;  ///< EDGE=ORDER
  std::string colour_by = "tetrahedron";
  std::string renderer = "faces";
  std::optional<double> cut_away;
  std::string moebius;
  std::string inside;  ///< as typed; empty: from outside
  std::optional<std::uint32_t> transparent;
  bool labels = false;
  bool dark = false;
  bool no_lines = false;
  bool hollow = false;
  geometry::Matrix4 motion = geometry::Matrix4::Identity();
  std::string discs;  ///< as typed; empty: not, or without a length
  DiscRequest disc_request;
  bool no_faces = false;
  bool no_truncations = false;
  std::size_t cells = 20;
  viewer::PictureOptions picture;
  int width = 0;
  int height = 0;
};

/// Names to what the viewers call it; the parser has let no other name through.
void name_choices(ViewCommand& command) {
  using viewer::ColourBy;
  using viewer::Model;
  viewer::PictureOptions& picture = command.picture;
  if (command.model == "upper") picture.model = Model::kUpperHalfSpace;
  if (command.model == "ball") picture.model = Model::kPoincareBall;
  if (command.model == "klein") picture.model = Model::kKleinBall;
  if (command.colour_by == "face") picture.colour_by = ColourBy::kFace;
  if (command.colour_by == "depth") picture.colour_by = ColourBy::kDepth;
  if (command.colour_by == "component") picture.colour_by = ColourBy::kComponent;
  if (command.colour_by == "edge") picture.colour_by = ColourBy::kEdge;
  if (command.renderer == "opencsg") picture.renderer = viewer::RendererKind::kOpenCsg;
}

/// A text as one word of a shell's command.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::strchr("_-./+:,", c) != nullptr;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The metric of an INPUT, ready to be developed.
struct Developed {
  Subject subject;
  structure::Report report;
  embedding::Embedding embedding;
  std::shared_ptr<const viewer::WallDiscs> discs;

  viewer::Scene scene(std::size_t cells, viewer::Model model) const {
    embedding::UniversalCoverOptions options;
    options.max_cells = cells;
    options.stop = &stop_flag();
    const auto cover = embedding::universal_cover(embedding, subject.triangulation, options);
    viewer::Scene scene =
        viewer::make_scene(printable(subject.name.empty() ? subject.input : subject.name),
                           embedding, cover, viewer::default_frame(model, embedding));
    scene.discs = discs;
    viewer::add_classes(scene, subject.triangulation, report.edge_lengths);
    return scene;
  }

  std::shared_ptr<const viewer::InsideManifold> from_inside() const {
    return std::make_shared<const viewer::InsideManifold>(
        viewer::inside_manifold(embedding, subject.triangulation, report.edge_lengths, discs));
  }
};

/// Without a number of cells it is a view from inside.
std::string as_json(const Subject& subject, const std::string& file,
                    std::optional<std::size_t> cells) {
  JsonText out;
  append_header(out, subject.input);
  append(out, fmt::format(", \"cells\": {}, \"file\": ", cells ? fmt::to_string(*cells) : "null"));
  append_string(out, file);
  out.push_back('}');
  return fmt::to_string(out);
}

/// The answer to --png, of which so many cells are drawn.
Reply picture_written(const Developed& developed, const ViewCommand& command, std::size_t drawn) {
  const bool interrupted = drawn < command.cells && stop_flag();
  const int status = interrupted ? kNoAnswer : kSuccess;
  if (command.common.json) return {as_json(developed.subject, command.png, drawn), status};
  return {
      fmt::format(
          "{}: {} of its universal cover drawn to {}{}\n", printable(developed.subject.input),
          counted(drawn, "cell", "cells"), printable(command.png),
          interrupted ? fmt::format(": {}, {} were asked for", stop_text(), command.cells) : ""),
      status};
}

Reply draw_picture(const Developed& developed, const ViewCommand& command) {
  if (!command.inside.empty()) {
    const auto manifold = developed.from_inside();
    viewer::write_png(viewer::render_inside(manifold, parse_inside(command.inside, *manifold),
                                            command.picture, command.width, command.height),
                      command.png);
    if (command.common.json) return {as_json(developed.subject, command.png, {}), kSuccess};
    return {fmt::format("{}: drawn from inside to {}\n", printable(developed.subject.input),
                        printable(command.png)),
            kSuccess};
  }
  const viewer::Scene scene = viewer::moved(
      command.picture.model, developed.scene(command.cells, command.picture.model), command.motion);
  const viewer::Image image =
      viewer::render_picture(scene, command.picture, command.width, command.height);
  const std::size_t drawn = scene.cells.size() - image.cells_left;
  if (drawn == 0) throw Stopped();  // no picture is better than an empty one
  viewer::write_png(image, command.png);
  return picture_written(developed, command, drawn);
}

/// The labels of the command line come on top of those of the input.
Subject load_with(const std::vector<std::string>& cone_orders, const std::string& input) {
  if (cone_orders.empty())
    return load_ideal_subject(input, Balls::kRefused, interruptible(), require_with_remedy);
  Subject subject = load_labelled_subject(input, Balls::kRefused, interruptible());
  LabelAssignment labels(subject.cone_angles, subject.triangulation.edge_count());
  for (const std::string& list : cone_orders)
    labels.assign("--cone-order", list, "EDGE=ORDER, such as 0=3", topology::parse_cone_order);
  require_with_remedy(subject.triangulation, subject.cone_angles);
  return subject;
}

PageRequest page_request(const ViewCommand& command) {
  return {command.page,        command.cells,  command.model,
          command.common.json, command.search, command.disc_request};
}

Reply view_one(const ViewCommand& command, const std::string& input) {
  Subject loaded = load_with(command.cone_orders, input);
  Solved solved = find_metric(std::move(loaded), {}, command.search);
  if (!solved.is_geometric()) {
    return {command.common.json ? report_as_json(solved.subject, solved.report, solved.search())
                                : report_as_text(solved.subject, solved.report, solved.search()),
            kNoAnswer};
  }
  Developed developed{std::move(solved.subject), std::move(solved.report), {}, {}};
  developed.embedding =
      embedding::embed(developed.subject.triangulation, developed.report.edge_lengths,
                       {developed.subject.cone_angles, 0});

  if (!command.page.empty()) {
    return write_page(developed.subject, developed.report, developed.embedding,
                      page_request(command));
  }
  developed.discs =
      discs_for(command.disc_request, developed.subject, developed.report, developed.embedding);
  if (command.png.empty()) {
    viewer::WindowOptions window;
    window.picture = command.picture;
    window.width = command.width;
    window.height = command.height;
    window.cells = command.cells;
    window.motion = command.motion;
    window.manifold = developed.from_inside();
    window.is_inside = !command.inside.empty();
    window.inside = parse_inside(command.inside, *window.manifold);
    window.command = "tripus view " + shell_word(input);
    for (const std::string& list : command.cone_orders) window.command += " --cone-order " + list;
    if (const MetricSearch& search = command.search; search.retriangulate)
      window.command += fmt::format(" --retriangulate --budget {} --seed {}", search.options.budget,
                                    search.options.seed);
    if (const auto& length = command.disc_request.length)
      window.discs += fmt::format(" {}", *length);
    viewer::show_window(
        [&](std::size_t cells, viewer::Model model) { return developed.scene(cells, model); },
        window);
    return {};
  }
  return draw_picture(developed, command);
}

/// --solid: no metric is looked for, all is in the file.
int view_solid(const ViewCommand& command) {
  if (command.page.empty()) throw InvalidInput("--solid needs a page to write: add -o FILE.html");
  declare_output("-o", command.page);
  const std::string text = read_file(command.solid);
  try {
    write_file(command.page, parameterise::solid_page(printable(command.solid),
                                                      parameterise::read_coloured_solid(text)));
  } catch (const InvalidInput& error) {
    throw InvalidInput(tripus::quoted(command.solid) + ": " + error.what());
  }
  return kSuccess;
}

int run(ViewCommand& command) {
  if (!command.solid.empty()) return view_solid(command);
  if (!command.common.batch.empty()) return write_gallery(command.common, page_request(command));
  if (!command.page.empty()) {
    check_pages(page_request(command));
    declare_output("-o", command.page);
  }
  if (!command.png.empty()) declare_output("--png", command.png);
  const auto [width, height] = parse_size(command.size);
  command.width = width;
  command.height = height;
  parse_camera(command.camera, command.picture.camera);
  name_choices(command);
  command.motion = parse_moebius(command.moebius);
  command.picture.transparent = command.transparent;
  command.picture.labels = command.labels;
  command.picture.dark = command.dark;
  command.picture.lines = !command.no_lines;
  if (command.hollow) command.picture.drawing = viewer::Material::kHollow;
  command.picture.cut_away = command.cut_away;
  command.picture.faces = !command.no_faces;
  command.picture.truncations = !command.no_truncations;
  command.picture.stop = &stop_flag();
  return answer_inputs(command.common,
                       [&](const std::string& input) { return view_one(command, input); });
}

void add_picture_options(CLI::App& verb, ViewCommand& command) {
  const auto flag = [&](const char* name, bool& wanted, const char* what) {
    verb.add_flag(name, wanted, what)->option_text(" ")->disable_flag_override();
  };
  verb.add_option("--cells", command.cells, "cells of the universal cover (default: 20)")
      ->option_text("N")
      ->check(CLI::Range(std::size_t{1}, viewer::kMostDrawnCells));
  verb.add_option("--model", command.model,
                  "ball: the Poincare ball (default); upper: the upper half-space; klein")
      ->option_text("NAME")
      ->check(CLI::IsMember({"upper", "ball", "klein"}));
  verb.add_option("--size", command.size, "of the picture or window (default: 1200x900)")
      ->option_text("WxH");
  verb.add_option("--colour-by", command.colour_by,
                  "tetrahedron (default), face, component (of the boundary), edge, or\n"
                  "depth: gluings away from the first cell")
      ->option_text("WHAT")
      ->check(CLI::IsMember({"tetrahedron", "face", "depth", "component", "edge"}));
  verb.add_option("--transparent", command.transparent,
                  "look through the cells of this tetrahedron")
      ->option_text("T");
  flag("--labels", command.labels, "write the names of tetrahedra and edges");
  flag("--no-lines", command.no_lines, "no lines along edges");
  flag("--hollow", command.hollow, "walls alone: hollow where they are cut");
  flag("--dark", command.dark, "a dark background");
  verb.add_option("--moebius", command.moebius,
                  "move all cells by w -> (aw + b)/(cw + d): real and imaginary parts\n"
                  "of a, b, c, d, eight numbers")
      ->option_text("NUMBERS");
  verb.add_option("--inside", command.inside,
                  "stand in the manifold and look along geodesics: at its centre, a wall\n"
                  "or an edge (key I of the window)")
      ->option_text("PLACE");
  flag("--no-truncations", command.no_truncations,
       "faces alone, so that one can look into the cells");
  flag("--no-faces", command.no_faces, "truncations alone: the geodesic boundary");
  verb.add_option("--discs", command.discs,
                  "draw on the boundary the discs of the arcs up to LENGTH that are\n"
                  "orthogonal to it (default: some hundred), coloured by length")
      ->option_text("[LENGTH]")
      ->expected(0, 1);
  verb.add_option("--cut-away", command.cut_away,
                  "cut the cells at the plane x = X of the model, and leave out\nwhat lies beyond")
      ->option_text("X");
  verb.add_option("--renderer", command.renderer,
                  "of pictures and windows: faces (default), or opencsg: the image-based\n"
                  "CSG of the founding paper, a reference that needs seconds")
      ->option_text("NAME")
      ->check(CLI::IsMember({"faces", "opencsg"}));
  verb.add_option("--camera", command.camera,
                  "azimuth and elevation in degrees, distance in radii of the scene\n"
                  "(default: 30,20,4.2); with three more numbers zoom and shift")
      ->option_text("A,E,D");
}

/// `--discs INPUT` is `INPUT --discs`: what is no number is no length.
void read_discs(const CLI::Option& discs, CLI::Option& input, ViewCommand& command) {
  command.disc_request = {discs.count() > 0, {}};
  if (!command.disc_request.wanted || command.discs.empty()) return;
  command.disc_request.length = parse_number(command.discs);
  const auto& length = command.disc_request.length;
  if (length && *length > 0 && *length <= orthospectrum::kLongestArc) return;
  if (length || input.count() > 0 || !command.common.batch.empty()) {
    throw CLI::ValidationError(
        "--discs", fmt::format("the length {} is not a number greater than 0 and at "
                               "most {}",
                               tripus::quoted(command.discs), orthospectrum::kLongestArc));
  }
  command.common.input = command.discs;
}

void add_view(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<ViewCommand>();
  auto* input = verb->add_option("INPUT", command->common.input,
                                 "an isomorphism signature, a file, or - for standard input")
                    ->option_text(" ")
                    ->transform(unshield());
  auto* png = verb->add_option("--png", command->png, "draw a picture, without any display")
                  ->option_text("FILE.png")
                  ->check(file_name({".png"}));
  auto* page = verb->add_option("-o", command->page, "write a page for a browser, in one file")
                   ->option_text("FILE.html")
                   ->check(file_name({".html", ".htm"}));
  auto* gallery =
      verb->add_option("--gallery", command->common.batch,
                       "a file with one INPUT a line: a page for each, and -o the index that\n"
                       "shows them all")
          ->option_text("FILE");
  auto* solid = verb->add_option("--solid", command->solid,
                                 "instead of an INPUT, a solid that tripus parameterise wrote:\n"
                                 "-o then shows it cut open, in the colours of the cells")
                    ->option_text("FILE.vtu");
  solid->excludes(input)->excludes(gallery)->excludes(png);
  png->excludes(page)->excludes(gallery);
  input->excludes(gallery);
  add_picture_options(*verb, *command);
  // A page has controls for these.
  for (const char* name : {"--size", "--colour-by", "--transparent", "--labels", "--no-lines",
                           "--hollow", "--dark", "--moebius", "--inside", "--no-truncations",
                           "--no-faces", "--cut-away", "--renderer", "--camera"})
    page->excludes(verb->get_option(name));
  verb->add_option("--cone-order", command->cone_orders,
                   "make an edge class singular of order N (cone angle 2pi/N): 0=2,1=3;\n"
                   "singular edges are red")
      ->option_text("EDGE=N")
      ->allow_extra_args(false)
      ->excludes(gallery);
  add_metric_search(*verb, command->search);
  verb->add_flag("--json", command->common.json, "one JSON object");
  verb->add_option("--threads", command->common.threads,
                   "threads for --gallery (default: all cores)")
      ->option_text("N")
      ->check(whole_number(1024));
  verb->add_flag("--quiet", command->common.quiet, "no progress on standard error");
  add_resume_option(*verb, command->common, gallery);
  verb->parse_complete_callback([gallery, verb, input, command] {
    if (!command->solid.empty()) return;
    read_discs(*verb->get_option("--discs"), *input, *command);
    require_input(command->common, input->count() > 0 || !command->common.input.empty(), *gallery);
  });
  verb->footer(std::string(kInputHelp) + "\n" + kExitStatusHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> view() {
  static constexpr Verb kRows[] = {
      {"view", "see the universal cover: window, picture or page for a browser", add_view, 17}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
