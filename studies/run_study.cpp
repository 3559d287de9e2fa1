#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "base/system_error.hpp"
#include "base/threads.hpp"
#include "base/version.hpp"
#include "studies/study.hpp"
#include "studies/write_report.hpp"
#include "topology/isosig.hpp"

namespace tripus::studies {
namespace {

/// What the items depend on.
std::string fingerprint(const Study& study, const StudyOptions& options) {
  std::uint64_t inputs = checksum("");
  for (const StudyInput& input : options.inputs) {
    inputs = checksum(input.name, inputs);
    for (std::size_t t = 0; t < input.gluings.tetrahedron_count(); ++t)
      for (int f = 0; f < 4; ++f)
        inputs = checksum(
            fmt::format("{} {} ", input.gluings.neighbour(t, f), input.gluings.gluing(t, f).rank()),
            inputs);
  }
  return fmt::format("tripus {} {} seed {} samples {} methods {} covers {} inputs {} {:016x}",
                     kVersion, study.name, options.seed, options.samples,
                     fmt::join(options.methods, ","), fmt::join(options.covers, ","),
                     options.inputs.size(), inputs);
}

/// Does the items that the store does not have yet.
class Workers {
 public:
  Workers(const Plan& plan, RowStore& store, const RunOptions& run)
      : plan_(plan), store_(store), run_(run), stop_(run.stop) {
    for (const Item& item : plan.items)
      if (!store.has(item.id)) left_.push_back(&item);
  }

  void run() {
    const std::size_t threads =
        std::min<std::size_t>(std::max(1u, run_.threads), std::max<std::size_t>(1, left_.size()));
    run_on_threads(threads, [this] { work(); });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  bool stopped() const { return failed_ || stop_; }

  void work() {
    try {
      for (std::size_t k = next_++; k < left_.size() && !stopped(); k = next_++) {
        std::vector<Row> rows = left_[k]->work(stop_);
        if (stopped()) return;  // they may be cut short
        store_.add(left_[k]->id, std::move(rows));
        const std::lock_guard lock(mutex_);
        if (run_.on_progress) run_.on_progress(store_.size(), plan_.items.size());
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  const Plan& plan_;
  RowStore& store_;
  const RunOptions& run_;
  Stop stop_;
  std::vector<const Item*> left_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

std::vector<Table> collect(const Plan& plan, const RowStore& store) {
  std::vector<Table> tables;
  for (const TableLayout& layout : plan.tables) tables.emplace_back(layout);
  for (const Item& item : plan.items)
    for (const Row& row : store.rows(item.id)) tables.at(row.table).add(row.cells);
  return tables;
}

void write_results(const ReportSource& source, const std::filesystem::path& folder,
                   RunResult& result) {
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file((folder / name).string(), text);
    result.files.push_back(name);
  };
  for (const Table& table : source.tables) write(table.layout().name + ".csv", to_csv(table));
  for (const Figure& figure : source.findings.figures) write(figure.name + ".svg", to_svg(figure));
  write("summary.json", summary_json(source));
  write("report.html", report_html(source));
  result.paragraph = source.findings.paragraph;
  result.facts = source.findings.facts;
}

}  // namespace

std::uint64_t item_seed(std::uint64_t seed, std::string_view id) {
  return Random(checksum(id, checksum(std::to_string(seed)))).bits();
}

std::uint64_t Random::bits() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double Random::uniform() { return double(bits() >> 11) * 0x1p-53; }

RunResult run_study(const Study& study, const StudyOptions& given, const RunOptions& run) {
  StudyOptions options = given;
  if (options.samples == 0) options.samples = study.default_samples;
  options.stop = run.stop;
  const Plan plan = study.plan(options);
  if (run.stop.requested()) return {};
  std::error_code failed;
  std::filesystem::create_directories(run.folder, failed);
  if (failed) fail_on_file("cannot make the folder", run.folder, failed.value());
  const std::filesystem::path folder(run.folder);
  RowStore store((folder / "items.jsonl").string(), fingerprint(study, options));
  RunResult result;
  result.total = plan.items.size();
  Workers(plan, store, run).run();
  for (const Item& item : plan.items) result.done += store.has(item.id);
  if (!result.finished()) return result;
  std::vector<Table> tables = collect(plan, store);
  Findings findings = plan.conclude(tables);
  tables.insert(tables.end(), findings.tables.begin(), findings.tables.end());
  write_results({study, options, run.threads, tables, findings}, folder, result);
  result.tables = std::move(tables);
  result.figures = std::move(findings.figures);
  return result;
}

}  // namespace tripus::studies
