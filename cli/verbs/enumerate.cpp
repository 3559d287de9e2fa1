// tripus enumerate: all triangulations with so many tetrahedra, as a stream of signatures.
#include "topology/enumerate.hpp"

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/in_order.hpp"
#include "base/output_file.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/shard.hpp"
#include "cli/tricensus.hpp"
#include "cli/verb.hpp"
#include "topology/isosig.hpp"
#include "topology/random_gluings.hpp"

namespace tripus::cli {
namespace {

using topology::LinkChoice;

/// Random triangulations that one thread draws in one go, each go from a seed of its own.
constexpr std::size_t kDrawnAtOnce = 500;

struct EnumerateCommand {
  int tetrahedra = 0, seed = 0;
  std::optional<int> random;
  std::optional<std::string> shard;
  std::string links = "geodesic", engine = "tripus", output;
  unsigned threads = 0;
  bool non_orientable = false, all = false, count_only = false, quiet = false;
};

/// A part of the answer.
struct Lines {
  std::string text;
  std::uint64_t count = 0;
};

/// Where the lines go: standard output, or a file that is whole or absent.
class ListSink {
 public:
  explicit ListSink(const EnumerateCommand& command) : count_only_(command.count_only) {
    if (command.output.empty()) return;
    declare_output("-o", command.output);
    file_.emplace(command.output);
  }
  void add(const Lines& lines) {
    count_ += lines.count;
    if (!count_only_) write(lines.text);
  }
  std::uint64_t count() const { return count_; }
  void close() {
    if (count_only_) write(fmt::format("{}\n", count_));
    if (!file_) return;
    if (stream_ == nullptr) stream_ = &file_->open();
    file_->close();
  }

 private:
  void write(const std::string& text) {
    if (!file_) {
      write_output(text);
      return;
    }
    if (stream_ == nullptr) stream_ = &file_->open();
    *stream_ << text;
    if (!*stream_) file_->close();  // throws
  }

  const bool count_only_;
  std::optional<OutputFile> file_;
  std::ostream* stream_ = nullptr;
  std::uint64_t count_ = 0;
};

LinkChoice parse_links(const std::string& text) {
  for (const LinkChoice links : {LinkChoice::kGeodesic, LinkChoice::kMixed, LinkChoice::kCusped})
    if (text == topology::to_string(links)) return links;
  throw InvalidInput("--links " + tripus::quoted(text) + ": write geodesic, mixed or cusped");
}

topology::EnumerationChoice choice_of(const EnumerateCommand& command) {
  using topology::Orientability;
  return {parse_links(command.links), command.all              ? Orientability::kBoth
                                      : command.non_orientable ? Orientability::kNonOrientable
                                                               : Orientability::kOrientable};
}

/// What `make(k)` gives for k = 0 ... count - 1, in that order. False if it was interrupted.
template <class Make>
bool write_in_order(const EnumerateCommand& command, std::size_t count, const Make& make,
                    ListSink& sink) {
  Progress progress(!command.quiet);
  const std::atomic<bool>& stop = interrupt_requested();
  const std::size_t done = in_order(
      count, thread_count(command.threads),
      [&](std::size_t k) -> std::optional<Lines> {
        Lines lines;
        if (!stop) make(k, lines);
        if (stop) return std::nullopt;
        return lines;
      },
      [&](std::size_t k, const Lines& lines) {
        sink.add(lines);
        if (progress.due())
          progress.show(fmt::format("{} triangulations, {} of {} parts", sink.count(), k, count));
        return true;
      });
  return done == count;
}

bool write_all(const EnumerateCommand& command, const Shard& shard, ListSink& sink) {
  const auto tetrahedra = static_cast<std::size_t>(command.tetrahedra);
  const topology::EnumerationChoice choice = choice_of(command);
  std::vector<topology::EnumerationPiece> pieces;
  std::size_t number = 0;
  for (auto& piece : topology::enumeration_pieces(tetrahedra, choice))
    if (shard.has(number++)) pieces.push_back(std::move(piece));
  return write_in_order(
      command, pieces.size(),
      [&](std::size_t k, Lines& lines) {
        const auto take = [&](const topology::Gluings& gluings, unsigned) {
          if (!command.count_only) lines.text += topology::isosig(gluings) + '\n';
        };
        lines.count =
            topology::enumerate(tetrahedra, choice, pieces[k], take, &interrupt_requested());
      },
      sink);
}

bool write_random(const EnumerateCommand& command, const Shard& shard, ListSink& sink) {
  const auto wanted = static_cast<std::size_t>(*command.random);
  const topology::EnumerationChoice choice = choice_of(command);
  const std::size_t parts = (wanted + kDrawnAtOnce - 1) / kDrawnAtOnce;
  return write_in_order(
      command, parts,
      [&](std::size_t k, Lines& lines) {
        if (!shard.has(k)) return;
        std::seed_seq seeds{static_cast<std::uint32_t>(command.seed),
                            static_cast<std::uint32_t>(k)};
        std::mt19937_64 random(seeds);
        const std::size_t count = std::min(kDrawnAtOnce, wanted - k * kDrawnAtOnce);
        for (; lines.count < count && !interrupt_requested(); ++lines.count)
          lines.text += topology::isosig(topology::random_gluings(
                            static_cast<std::size_t>(command.tetrahedra), choice, random)) +
                        '\n';
      },
      sink);
}

/// What Regina's program finds, in its order.
bool write_tricensus(const EnumerateCommand& command, ListSink& sink) {
  Lines lines;
  const bool whole = for_each_of_tricensus(static_cast<std::size_t>(command.tetrahedra),
                                           choice_of(command), [&](const std::string& signature) {
                                             lines.text += signature + '\n';
                                             ++lines.count;
                                           });
  if (whole) sink.add(lines);
  return whole;
}

int run(const EnumerateCommand& command) {
  parse_links(command.links);
  const Shard shard = command.shard ? parse_shard(*command.shard) : Shard{};
  if (command.engine != "tripus" && command.engine != "tricensus")
    throw InvalidInput("--engine " + tripus::quoted(command.engine) +
                       ": write tripus or tricensus");
  if (command.engine == "tricensus" && (command.shard || command.random))
    throw InvalidInput("--engine tricensus knows neither --shard nor --random");
  ListSink sink(command);
  const auto rest = [&] { return fmt::format(" after {} triangulations", sink.count()); };
  set_last_words(command.output.empty() ? " before all triangulations were written"
                                        : "; no file was written");
  const bool whole = command.engine == "tricensus" ? write_tricensus(command, sink)
                     : command.random              ? write_random(command, shard, sink)
                                                   : write_all(command, shard, sink);
  if (!whole) {
    write_message("tripus: " + stop_text() + rest() +
                  (command.output.empty() ? "\n" : "; no file was written\n"));
    return kNoAnswer;
  }
  sink.close();
  if (!command.quiet)
    write_message(fmt::format("{}\n", counted(sink.count(), "triangulation", "triangulations")));
  return kSuccess;
}

constexpr const char* kEnumerateFooter =
    "\nOrientable ones, unless --non-orientable or --all says otherwise; no edge is glued to "
    "itself\n"
    "the other way round. Each line is an isomorphism signature; mirror images count as one. The\n"
    "order is fixed, whatever the threads, and the shards together have every line once. The list "
    "is what\n"
    "`tripus census --from` and --batch of other verbs take; docs/census.md tells how long it "
    "gets.\n"
    "\nExit status: 0 done, 1 interrupted (-o then leaves the old file), 2 bad usage,\n"
    "3 a failure of the program itself.";

void add_enumerate(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<EnumerateCommand>();
  constexpr int kMost = std::numeric_limits<int>::max();
  verb->add_option("N", command->tetrahedra, "the number of tetrahedra")
      ->option_text(" ")
      ->required()
      ->check(CLI::Range(1, static_cast<int>(topology::kMaxEnumerated)).description(""));
  verb->add_option("--links", command->links,
                   "which vertex links: geodesic (all of genus >= 2, the default), mixed\n"
                   "(of genus >= 2 and tori, both), cusped (tori; or Klein bottles)")
      ->option_text("KIND");
  auto* non_orientable =
      verb->add_flag("--non-orientable", command->non_orientable, "those that are not orientable")
          ->option_text(" ");
  verb->add_flag("--all", command->all, "orientable or not")
      ->option_text(" ")
      ->excludes(non_orientable);
  verb->add_option("--shard", command->shard, "the I-th of M parts of the list only")
      ->option_text("I/M");
  auto* random = verb->add_option("--random", command->random,
                                  "instead of all, so many random ones; repetitions happen")
                     ->option_text("COUNT")
                     ->check(whole_number(kMost));
  verb->add_option("--seed", command->seed, "of the random ones (default: 0)")
      ->option_text("N")
      ->check(whole_number(kMost))
      ->needs(random);
  verb->add_option("--engine", command->engine,
                   "tripus (default) or tricensus, Regina's program, where it is installed")
      ->option_text("NAME");
  verb->add_flag("--count", command->count_only, "print their number only")
      ->option_text(" ")
      ->excludes(random);
  verb->add_option("-o,--output", command->output, "write a file: whole, or not at all")
      ->option_text("FILE")
      ->check(problem_of_name);
  verb->add_option("--threads", command->threads, "threads (default: all cores)")
      ->option_text("N")
      ->check(whole_number(1024));
  verb->add_flag("--quiet", command->quiet, "no progress and no number on standard error")
      ->option_text(" ");
  verb->footer(kEnumerateFooter);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> enumerate() {
  static constexpr Verb kRows[] = {
      {"enumerate", "all triangulations with so many tetrahedra, for a census", add_enumerate, 9}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
