// tripus cover: finite covers, as a stream.
#include <charconv>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <unordered_set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/output_file.hpp"
#include "base/system_error.hpp"
#include "canonical/canonize.hpp"
#include "cli/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/batch_output.hpp"
#include "cli/canonize_options.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/help.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/verb.hpp"
#include "manifold/load.hpp"
#include "topology/covers/covers.hpp"
#include "topology/formats/formats.hpp"
#include "topology/homology.hpp"
#include "topology/work_size.hpp"

namespace tripus::cli {
namespace {

using topology::Cover;

/// A cover and its description take some hundred bytes a tetrahedron.
constexpr std::size_t kMostTetrahedra = 5'000'000;

struct CoverCommand {
  CommonOptions common;
  int cyclic = 0, degree = 0;  ///< one of them is given
  std::optional<std::string> cyclic_class;
  int limit = 0;  ///< 0: none
  bool orientable = false;
  bool distinct = false;
  canonical::CanonizeOptions canonize;  ///< to tell them apart
  std::string output;

  std::size_t sheets() const {
    return static_cast<std::size_t>(orientable ? 2 : cyclic > 0 ? cyclic : degree);
  }
};

/// The part of a cover's name that comes before its number, in a folder.
constexpr const char* kFilePrefix = "cover-";

/// Where covers go: lines to standard output, a file or after an earlier run's (--resume), or a
/// file each to a folder as well.
class CoverSink {
 public:
  CoverSink(const CoverCommand& command, const std::vector<topology::BatchLine>& inputs)
      : path_(command.output),
        resumed_(command.common.resume, asked(command.common), inputs, AnswersPerLine::kAnyNumber) {
    if (path_.empty()) return;
    std::error_code error;
    if (path_.ends_with('/')) {
      std::filesystem::create_directories(path_, error);
      if (error) fail_on_file("cannot make the folder", path_, error.value());
    }
    folder_ = std::filesystem::is_directory(path_, error);
    if (folder_) {
      declare_output_folder(path_, kFilePrefix);
      return;
    }
    declare_output("-o", path_);
    file_.emplace(path_);
  }

  void add(const std::string& line, const topology::NamedGluings& cover) {
    ++count_;
    if (folder_) {
      const auto name = fmt::format("{}{:06}.json", kFilePrefix, count_);
      write_file((std::filesystem::path(path_) / name).string(), topology::write_json(cover));
    }
    write_line(line);
  }
  void comment(const std::string& text) { write_line("# " + text); }
  /// An error as an answer, which is not for the file.
  void failure(const std::string& line) {
    if (file_) {
      write_output(line + '\n');
      flush_output();
    } else {
      resumed_.write(line + '\n');
    }
  }
  std::size_t first() const { return resumed_.answered(); }
  std::size_t count() const { return count_; }
  /// The file comes to its name, with what there is.
  void close() {
    if (!file_ || count_ == 0) return;
    lines();
    file_->close();
  }

 private:
  /// The file is begun with the first line: a bad input leaves an old one alone.
  std::ostream& lines() {
    if (lines_ == nullptr) lines_ = &file_->open();
    return *lines_;
  }
  void write_line(const std::string& line) {
    if (file_) {
      lines() << line << '\n';
      if (file_->is_direct()) lines().flush();
      if (!lines()) file_->close();  // throws
    } else {
      resumed_.write(line + '\n');
    }
  }

  std::string path_;
  BatchOutput resumed_;
  bool folder_ = false;
  std::optional<OutputFile> file_;
  std::ostream* lines_ = nullptr;
  std::size_t count_ = 0;
};

/// "1,0,-2"
std::vector<std::int64_t> parse_class(const std::string& text) {
  std::vector<std::int64_t> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    std::int64_t value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || (next != end && *next != ','))
      throw InvalidInput("--class " + tripus::quoted(text) + ": entry " +
                         std::to_string(values.size() + 1) +
                         " is no whole number; write them as 1,0,-2");
    values.push_back(value);
    if (next == end) return values;
    at = next + 1;
  }
}

/// Which subgroup: how faces of the base, whose loops generate the group, permute the sheets.
void append_permutations(JsonText& out, const Cover& cover) {
  if (cover.permutations.empty()) return;
  append(out, ", \"permutations\": ");
  append_array(out, cover.permutations, [](JsonText& to, const topology::SheetPermutation& each) {
    fmt::format_to(std::back_inserter(to),
                   "{{\"tetrahedron\": {}, \"face\": {}, \"images\": [{}]}}", each.tetrahedron,
                   each.face, fmt::join(each.images, ", "));
  });
}

/// "(0 1 2)(3 4)"; "()" if nothing moves.
std::string cycles(const std::vector<std::uint32_t>& images) {
  std::string text;
  std::vector<char> seen(images.size());
  for (std::uint32_t first = 0; first < images.size(); ++first) {
    if (seen[first] || images[first] == first) continue;
    std::vector<std::uint32_t> cycle;
    for (std::uint32_t sheet = first; !seen[sheet]; sheet = images[sheet]) {
      seen[sheet] = 1;
      cycle.push_back(sheet);
    }
    text += fmt::format("({})", fmt::join(cycle, " "));
  }
  return text.empty() ? "()" : text;
}

/// "; sheets by faces 0.2: (0 1), 1.3: ()"
std::string permutations_text(const Cover& cover) {
  constexpr std::size_t kShown = 6;
  std::vector<std::string> parts;
  for (const topology::SheetPermutation& each : cover.permutations)
    parts.push_back(fmt::format("{}.{} {}", each.tetrahedron, each.face, cycles(each.images)));
  return parts.empty() ? "" : fmt::format("; sheets by faces: {}", shortened(parts, kShown));
}

std::string as_json(const Subject& subject, const Cover& cover, std::size_t number) {
  const topology::Triangulation& m = subject.triangulation;
  JsonText out;
  append_header(out, subject.input);
  auto to = std::back_inserter(out);
  fmt::format_to(to, ", \"cover\": {}, \"degree\": {}, \"deck_group_order\": {}, \"regular\": {}",
                 number, cover.degree, cover.deck_group_order, cover.is_regular());
  if (!cover.cyclic_class.empty())
    fmt::format_to(to, ", \"class\": [{}]", fmt::join(cover.cyclic_class, ", "));
  append_permutations(out, cover);
  append_subject(out, subject);
  append_oriented(out, subject);
  append_vertices(out, m);
  append(out, ", \"H1\": ");
  append_string(out, topology::to_string(topology::first_homology(m)));
  append(out, ", ");
  const std::string table = topology::write_json({{}, m.gluings()});  // {"gluings": ...}, line end
  append(out, std::string_view(table).substr(1, table.size() - 2));
  return fmt::to_string(out);
}

/// A line that --batch takes: a signature and a comment.
std::string as_text(const Subject& subject, const Cover& cover, std::size_t number) {
  const topology::Triangulation& m = subject.triangulation;
  std::string text = subject.isosig
                         ? *subject.best_signature() + "  # "
                         : fmt::format("# cover {}, whose signature would take too long: ", number);
  text += fmt::format("{}; H1 {}", one_line(m), topology::to_string(topology::first_homology(m)));
  if (cover.cyclic_class.empty()) {
    text += cover.is_regular() ? "; regular" : "";
    text += permutations_text(cover);
  } else {
    text += fmt::format("; class {}", fmt::join(cover.cyclic_class, ","));
  }
  return text;
}

std::string no_cover(const CoverCommand& command, const topology::Triangulation& base) {
  if (command.degree > 0)
    return fmt::format("there is no connected cover of degree {}", command.degree);
  return fmt::format("there is no cyclic cover of degree {}: H1 is {}, which has no map onto Z/{}",
                     command.cyclic, topology::to_string(topology::first_homology(base)),
                     command.cyclic);
}

/// Tells manifolds apart: by their isometry signatures, or, where there is none, by the signatures
/// of their triangulations.
class DistinctManifolds {
 public:
  explicit DistinctManifolds(const canonical::CanonizeOptions& options) : options_(options) {}

  /// Whether the manifold is none of those before, as far as can be told.
  bool add(const Subject& subject) {
    if (!subject.isosig) return true;
    if (!triangulations_.insert(*subject.isosig).second) return false;
    canonical::CanonizeOptions options = options_;
    limit_work(options);
    options.solve.evidence = false;
    try {
      const auto answer = canonical::canonize(subject.triangulation, options);
      return !answer.manifold || manifolds_.insert(answer.manifold->signature.unoriented).second;
    } catch (const InvalidInput&) {  // no geodesic boundary
      return true;
    }
  }

 private:
  const canonical::CanonizeOptions& options_;
  std::unordered_set<std::string> triangulations_, manifolds_;
};

/// Writes the covers of one INPUT; the exit status it deserves.
int write_covers(const CoverCommand& command, const std::string& input, CoverSink& sink,
                 Progress& progress) {
  const topology::NamedGluings loaded = load_manifold_input(input, interruptible());
  const topology::Triangulation base(loaded.gluings);
  if (command.sheets() > kMostTetrahedra / base.tetrahedron_count())
    throw InvalidInput(fmt::format(
        "degree {}: the cover would have {} tetrahedra; at most {} are made here", command.sheets(),
        command.sheets() * base.tetrahedron_count(), kMostTetrahedra));
  topology::note_work_size(command.sheets() * base.tetrahedron_count());
  std::size_t number = 0, written = 0;
  DistinctManifolds distinct(command.canonize);
  const auto visit = [&](const Cover& cover) {
    ++number;
    const Subject subject = make_subject(
        input, {loaded.name, cover.gluings, {}, loaded.notes, loaded.orientation_known});
    if (command.distinct && !distinct.add(subject)) return !stop_flag();
    ++written;
    sink.add(
        command.common.json ? as_json(subject, cover, number) : as_text(subject, cover, number),
        {fmt::format("{}, degree {}, cover {}", loaded.name.empty() ? input : loaded.name,
                     cover.degree, number),
         cover.gluings});
    if (progress.due()) progress.show(fmt::format("{} covers", sink.count()));
    return written != static_cast<std::size_t>(command.limit) && !stop_flag();
  };
  const Stop stop = &stop_flag();
  if (command.orientable) {
    visit(topology::orientable_double_cover(base));
  } else if (command.cyclic_class) {
    visit(topology::cyclic_cover_of_class(base, command.sheets(),
                                          parse_class(*command.cyclic_class)));
  } else if (command.cyclic > 0) {
    topology::for_each_cyclic_cover(base, command.sheets(), visit, stop);
  } else {
    topology::for_each_cover(base, command.sheets(), visit, stop);
  }
  if (written < number && !command.common.quiet)
    write_message(fmt::format("tripus: {}: {} left out: the same manifolds as others\n",
                              printable(input), counted(number - written, "cover", "covers")));
  if (number > 0 || stop_flag()) return kSuccess;
  write_message(fmt::format("tripus: {}: {}\n", printable(input), no_cover(command, base)));
  return kNoAnswer;
}

int run(const CoverCommand& command) {
  const bool batch = !command.common.batch.empty();
  if (!command.common.resume.empty()) declare_output("--resume", command.common.resume);
  std::vector<topology::BatchLine> inputs{{0, command.common.input}};
  if (batch) inputs = read_batch_file(command.common.batch);
  CoverSink sink(command, inputs);
  require_not_written(command.common.batch);
  int status = kSuccess, worst = kSuccess;
  for (std::size_t i = sink.first(); i < inputs.size(); ++i) {
    const std::string& input = inputs[i].text;
    const auto rest = [&] {
      return fmt::format(
          " after {}{}", counted(sink.count(), "cover", "covers"),
          batch ? fmt::format(", of the first {} of {} inputs", i, inputs.size()) : "");
    };
    set_last_words(rest());
    const LineLimit limit;
    topology::begin_work();
    try {
      require_not_written(input);
      if (batch && !command.common.json) sink.comment(printable(input));
      if (batch && input == "-") throw InvalidInput(kNoStandardInput);
      Progress progress(!command.common.quiet);
      status = write_covers(command, input, sink, progress);
    } catch (const IoError&) {
      throw;  // of a file or standard output: the next line will not fare better
    } catch (const std::exception& error) {
      status = status_of(error);
      const Answer answer = error_answer(input, command.common.json, error);
      if (!interrupt_requested() && !answer.text.empty()) sink.failure(answer.text);
      if (!interrupt_requested())
        write_message(
            batch ? fmt::format("tripus: line {}: {}\n", inputs[i].line_number, answer.message)
                  : fmt::format("tripus: {}\n", answer.message));
    }
    if (status == kInternalFailure) worst = kInternalFailure;
    if (!interrupt_requested()) {
      if (status == kSuccess && is_time_over())
        write_message(fmt::format("tripus: line {}: {}: there may be more covers\n",
                                  inputs[i].line_number, stop_text()));
      continue;
    }
    sink.close();
    write_message("tripus: " + stop_text() + rest() + "\n");
    return kNoAnswer;
  }
  sink.close();
  return batch ? worst : status;
}

constexpr const char* kCoverFooter =
    "\nEach line is a signature and, after #, what it is, so that the covers can be piped:\n"
    "  tripus cover cPcbbbihq --degree 3 | tripus solve --batch - --json\n"
    "Tetrahedron t of INPUT, with T tetrahedra, is number t + T k on sheet k in the table that\n"
    "--json and -o FOLDER/ write. Two covers may be the same manifold: see --distinct.\n"
    "Signatures have a sign, which keeps the orientation, if INPUT does. Covers of a degree are "
    "told by\n"
    "how loops through faces (tetrahedron.face) permute the sheets; the subgroup is that of the "
    "loops\n"
    "which lead from sheet 0 back to it.\n"
    "\nExit status: 0 done, 1 there is no such cover or interrupted, 2 bad usage or bad input,\n"
    "3 a failure of the program itself.";

void add_cover(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<CoverCommand>();
  constexpr int kMost = std::numeric_limits<int>::max();
  auto* cyclic = verb->add_option("--cyclic", command->cyclic,
                                  "connected cyclic covers with N sheets: the classes of H^1\n"
                                  "that are onto Z/N, up to units")
                     ->option_text("N")
                     ->check(whole_number(kMost));
  auto* degree = verb->add_option("--degree", command->degree,
                                  "all connected covers with N sheets up to isomorphism; their\n"
                                  "number explodes: for N up to 7 or so")
                     ->option_text("N")
                     ->check(whole_number(kMost));
  cyclic->excludes(degree);
  verb->add_flag("--orientable", command->orientable,
                 "the orientable cover with two sheets of a non-orientable manifold")
      ->option_text(" ")
      ->excludes(cyclic)
      ->excludes(degree);
  auto* distinct =
      verb->add_flag("--distinct", command->distinct,
                     "leave out covers that are homeomorphic to one before, mirror images\n"
                     "too; where there is no metric, that have the same triangulation")
          ->option_text(" ");
  add_canonize_options(*verb, command->canonize);
  verb->get_option("--budget")->needs(distinct);
  verb->add_option("--class", command->cyclic_class,
                   "only the cyclic cover of this class: its values modulo N on the\n"
                   "summands of H1, in the order in which `tripus info` prints them")
      ->option_text("A,B,...")
      ->needs(cyclic);
  verb->add_option("--limit", command->limit, "stop after N covers of an INPUT (default: none)")
      ->option_text("N")
      ->check(whole_number(kMost));
  verb->add_option("-o,--output", command->output,
                   "write the lines to this file; or, for a folder (FOLDER/), also every\n"
                   "cover as a gluing table in a file of its own")
      ->option_text("FILE")
      ->check(problem_of_name);
  add_input_options(*verb, command->common, "their covers follow one another");
  verb->add_flag("--json", command->common.json, "one JSON object for each cover, one a line");
  verb->footer(std::string(kInputHelp) + kCoverFooter);
  verb->final_callback([command, cyclic, degree, &chosen] {
    if (cyclic->count() + degree->count() == 0 && !command->orientable)
      throw CLI::RequiredError("--cyclic N or --degree N or --orientable");
    chosen = [command] { return run(*command); };
  });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> cover() {
  static constexpr Verb kRows[] = {
      {"cover", "finite covers: cyclic ones, or all of a degree", add_cover, 5}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
