// The shared parts of the studies: tables, the row store, runs, figures.
#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "studies/figure.hpp"
#include "studies/row_store.hpp"
#include "studies/study.hpp"
#include "studies/table.hpp"
#include "topology/isosig.hpp"

namespace tripus::studies {
namespace {

namespace fs = std::filesystem;

class Folder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "tripus-studies-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  fs::path folder_;
};

TEST(Table, WritesCsvWithQuotesWhereTheyAreNeeded) {
  Table table({"t", "", {{"name", "", ""}, {"value", "", ""}}});
  table.add(cells("a, \"b\"", 0.1));
  table.add(cells("plain", std::nan("")));
  EXPECT_EQ(to_csv(table), "name,value\n\"a, \"\"b\"\"\",0.1\nplain,\n");
  EXPECT_EQ(table.number(0, "value"), 0.1);
  EXPECT_TRUE(std::isnan(table.number(1, "value")));
}

TEST(Table, RefusesRowsOfAnotherWidth) {
  Table table({"t", "", {{"name", "", ""}}});
  EXPECT_THROW(table.add({"a", "b"}), InternalError);
  EXPECT_THROW(table.column("other"), InternalError);
}

TEST(Cell, KeepsAllDigits) {
  EXPECT_EQ(cell(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(cell(-0.0), "0");
  EXPECT_EQ(cell(true), "yes");
  EXPECT_EQ(cell(std::size_t{7}), "7");
}

using Store = Folder;

TEST_F(Store, KeepsItemsOverRuns) {
  const std::string path = folder_ / "items";
  {
    RowStore store(path, "a study");
    store.add("one", {{0, {"x", "1"}}, {1, {"y"}}});
    store.add("two", {});
  }
  RowStore store(path, "a study");
  EXPECT_EQ(store.size(), 2u);
  EXPECT_TRUE(store.has("two"));
  ASSERT_EQ(store.rows("one").size(), 2u);
  EXPECT_EQ(store.rows("one")[0].cells, (std::vector<std::string>{"x", "1"}));
  EXPECT_EQ(store.rows("one")[1].table, 1u);
}

TEST_F(Store, DropsWhatWasCutOffAnywhere) {
  const fs::path path = folder_ / "items";
  {
    RowStore store(path, "a study");
    store.add("one", {{0, {"x"}}});
    store.add("two", {{0, {"y"}}});
  }
  const std::string whole = read(path);
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, length);
    {
      RowStore store(path, "a study");
      EXPECT_LE(store.size(), 2u);
      if (!store.has("one")) store.add("one", {{0, {"x"}}});
      if (!store.has("two")) store.add("two", {{0, {"y"}}});
    }
    EXPECT_EQ(read(path), whole) << "cut after " << length << " bytes";
  }
}

TEST_F(Store, RefusesAnotherStudy) {
  const std::string path = folder_ / "items";
  RowStore(path, "a study").add("one", {});
  EXPECT_THROW(RowStore(path, "another"), InvalidInput);
}

using StudyRun = Folder;

StudyOptions tripus_options() {
  StudyOptions options;
  options.inputs.push_back({"cPcbbbihq", topology::decode_isosig("cPcbbbihq")});
  options.samples = 6;
  return options;
}

TEST_F(StudyRun, StoppedAndResumedGivesTheSameCsvOnAnyNumberOfThreads) {
  const Study& study = find_study("stability");
  const auto run = [&](const char* name, unsigned threads, std::size_t stop_after) {
    std::atomic<bool> stop{false};
    RunOptions options{(folder_ / name).string(), threads, &stop, {}};
    std::size_t calls = 0;
    options.on_progress = [&](std::size_t, std::size_t) { stop = ++calls >= stop_after; };
    return run_study(study, tripus_options(), options);
  };
  ASSERT_TRUE(run("whole", 1, 100000).finished());
  ASSERT_TRUE(run("threads", 3, 100000).finished());
  int runs = 1;
  while (!run("stopped", 2, 7).finished()) {
    EXPECT_FALSE(fs::exists(folder_ / "stopped" / "starts.csv"));
    ASSERT_LT(++runs, 1000);
  }
  EXPECT_GT(runs, 3);
  for (const char* file : {"thresholds.csv", "angles.csv", "irregular_angles.csv", "starts.csv",
                           "flow_thresholds.csv", "outcomes.csv"}) {
    const std::string expected = read(folder_ / "whole" / file);
    EXPECT_GT(expected.size(), 50u);
    EXPECT_EQ(read(folder_ / "threads" / file), expected);
    EXPECT_EQ(read(folder_ / "stopped" / file), expected);
  }
}

/// An item that never ends by itself, and one that has to wait for it.
Plan endless_plan(const StudyOptions&) {
  Plan plan;
  plan.tables = {{"t", "", {{"value", "", ""}}}};
  plan.items.push_back({"endless", [](const Stop& stop) {
                          while (!stop) std::this_thread::yield();
                          return std::vector<Row>{{0, {"cut short"}}};
                        }});
  plan.items.push_back({"quick", [](const Stop&) { return std::vector<Row>{{0, {"whole"}}}; }});
  plan.conclude = [](const std::vector<Table>&) { return Findings(); };
  return plan;
}

TEST_F(StudyRun, StopsWithinAnItemAndKeepsNothingOfIt) {
  const Study study{"endless", "", "", 1, "", endless_plan};
  std::atomic<bool> stop{false};
  RunOptions options{folder_.string(), 2, &stop, {}};
  options.on_progress = [&](std::size_t, std::size_t) { stop = true; };  // once "quick" is done
  const RunResult result = run_study(study, tripus_options(), options);
  EXPECT_FALSE(result.finished());
  EXPECT_EQ(result.done, 1u);
  EXPECT_EQ(result.total, 2u);
  EXPECT_THAT(read(folder_ / "items.jsonl"), ::testing::Not(::testing::HasSubstr("cut short")));
}

TEST_F(StudyRun, StopsBeforeItsPlanIsMade) {
  const std::atomic<bool> stop{true};
  for (const Study& study : studies()) {
    const RunResult result = run_study(
        study, tripus_options(), {(folder_ / std::string(study.name)).string(), 1, &stop, {}});
    EXPECT_FALSE(result.finished()) << study.name;
    EXPECT_TRUE(result.files.empty());
  }
}

TEST_F(StudyRun, ReportIsOnePageWithItsFigures) {
  const RunResult result =
      run_study(find_study("stability"), tripus_options(), {folder_.string(), 1, nullptr, {}});
  ASSERT_TRUE(result.finished());
  const std::string page = read(folder_ / "report.html");
  EXPECT_THAT(page, ::testing::HasSubstr("<svg"));
  EXPECT_THAT(page, ::testing::HasSubstr("37.77"));
  for (const char* outside : {"<script", "src=", "href="})
    EXPECT_THAT(page, ::testing::Not(::testing::HasSubstr(outside)));
  EXPECT_THAT(read(folder_ / "summary.json"), ::testing::HasSubstr("\"processor\""));
}

TEST(Random, IsTheSameEverywhere) {
  Random random(0);  // splitmix64's published first output for seed 0
  EXPECT_EQ(random.bits(), 0xe220a8397b1dcdafu);
  EXPECT_NE(item_seed(1, "a"), item_seed(1, "b"));
  EXPECT_NE(item_seed(1, "a"), item_seed(2, "a"));
}

TEST(Figures, LeaveOutWhatALogarithmCannotShow) {
  Figure figure;
  figure.title = "a < b";
  figure.x = {"x (unit)", false, 0, 10, {}};
  figure.y = {"y (unit)", true, 1e-3, 1e3, {}};
  figure.series = {
      {"s", Mark::kPoint, {{1, 1}, {2, 0}, {3, -1}, {4, std::nan("")}, {5, 10}, {6, 1e9}}, {}, 0}};
  const std::string svg = to_svg(figure);
  std::size_t marks = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos;
       at = svg.find("<circle", at + 1))
    ++marks;
  EXPECT_EQ(marks, 3u);  // two points and the legend
  EXPECT_THAT(svg, ::testing::HasSubstr("a &lt; b"));
  EXPECT_THAT(svg, ::testing::Not(::testing::HasSubstr("nan")));
}

TEST(Studies, AreFoundByName) {
  EXPECT_EQ(find_study("stability").name, "stability");
  EXPECT_THROW(find_study("nothing"), InvalidInput);
}

}  // namespace
}  // namespace tripus::studies
