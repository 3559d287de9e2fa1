#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stop.hpp"
#include "studies/figure.hpp"
#include "studies/row_store.hpp"
#include "studies/table.hpp"
#include "topology/gluings.hpp"

namespace tripus::studies {

/// A triangulation to study.
struct StudyInput {
  std::string name;  ///< a signature, or the name of a file
  topology::Gluings gluings;
};

struct StudyOptions {
  std::vector<StudyInput> inputs;
  std::uint64_t seed = 1;
  std::size_t samples = 0;           ///< how much of it; 0: the study's default
  std::vector<std::string> methods;  ///< where the study compares methods; empty: all
  std::vector<std::size_t> covers;   ///< degrees of cyclic covers to add, where it does that
  Stop stop{};                       ///< polled while the plan is made; no part of the study
};

/// A piece of work that depends on nothing but its own data: done in any order, on any thread.
struct Item {
  std::string id;  ///< unique in the study, the same in every run
  /// Polls the stop where it takes long, and returns early with anything: what is returned once it
  /// is requested is thrown away.
  std::function<std::vector<Row>(const Stop& stop)> work;
};

/// A number among the findings.
struct Fact {
  std::string name;  ///< snake_case, for the JSON summary
  double value = 0;
  std::string description;  ///< with the unit
};

/// What the data say.
struct Findings {
  std::string paragraph;
  std::vector<Fact> facts;
  std::vector<Figure> figures;
  std::vector<Table> tables = {};  ///< written beside those of the items, and computed from them
};

struct Plan {
  std::vector<TableLayout> tables;
  std::vector<Item> items;
  /// Reads the finished tables, in the order of `tables`; rows are in the order of `items`.
  std::function<Findings(const std::vector<Table>&)> conclude;
};

/// One line of the table of studies.
struct Study {
  std::string_view name;
  std::string_view title;
  std::string_view description;  ///< one line for `tripus study --help`
  std::size_t default_samples;
  std::string_view samples;  ///< what `samples` counts
  Plan (*plan)(const StudyOptions& options);
};

std::span<const Study> studies();
/// Throws InvalidInput with the names there are.
const Study& find_study(std::string_view name);

struct RunOptions {
  std::string folder;  ///< made if need be
  unsigned threads = 1;
  Stop stop{};  ///< polled between items and within long ones
  std::function<void(std::size_t done, std::size_t total)> on_progress;  ///< one call at a time
};

struct RunResult {
  std::size_t done = 0;
  std::size_t total = 0;
  bool finished() const { return total > 0 && done == total; }
  std::string paragraph;           ///< the findings, if finished
  std::vector<Fact> facts;         ///< the same in numbers
  std::vector<std::string> files;  ///< written, in the folder
  std::vector<Table> tables;       ///< what the files hold, if finished
  std::vector<Figure> figures;
};

/// Does what is left to do of the study in the folder, on all threads. When every item is done,
/// writes one CSV a table, summary.json, the figures and report.html; otherwise only the finished
/// items are kept (items.jsonl), and calling it again goes on from there. The CSV files depend on
/// inputs, options and seed alone, timing columns aside.
/// Throws InvalidInput for what the study cannot use, and if the folder cannot be written or holds
/// another study.
RunResult run_study(const Study& study, const StudyOptions& options, const RunOptions& run);

/// A seed of its own for every item, from the study's seed and the item's id.
std::uint64_t item_seed(std::uint64_t seed, std::string_view id);

/// Random numbers that are the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();  ///< 64 of them (splitmix64)
  double uniform();      ///< in [0, 1)
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

 private:
  std::uint64_t state_;
};

}  // namespace tripus::studies
