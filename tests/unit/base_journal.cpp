#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/journal.hpp"

namespace tripus {
namespace {

constexpr const char* kHeader = "# tripus test: version 1";

class Journals : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "tripus-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    path_ = (folder_ / "journal").string();
    Journal journal(path_, kHeader);
    for (const char* line : {"one", "{\"two\": 2}", "three\t3"}) journal.add(line);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }
  void write(const std::string& text) const { std::ofstream(path_) << text; }
  std::string refusal(const std::string& header = kHeader) const {
    try {
      Journal journal(path_, header);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_;
  std::string path_;
};

TEST_F(Journals, SayWhatTheyWereTold) {
  const Journal journal(path_, kHeader);
  EXPECT_THAT(journal.lines(), ::testing::ElementsAre("one", "{\"two\": 2}", "three\t3"));
  EXPECT_THAT(journal.place(1), ::testing::HasSubstr("line 3"));
}

TEST_F(Journals, LoseOnlyATornLastLine) {
  const std::string whole = text();
  const std::size_t last = whole.find("three");
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    write(whole.substr(0, cut));
    Journal journal(path_, kHeader);
    const auto lines = std::count(whole.begin(), whole.begin() + long(cut), '\n');
    EXPECT_EQ(journal.lines().size(), std::size_t(std::max<long>(lines - 1, 0))) << cut;
    if (cut < last) continue;
    journal.add("three\t3");
    EXPECT_EQ(text(), whole) << cut;
  }
}

TEST_F(Journals, RefuseEveryChangedByteButTheLastLineEnd) {
  const std::string whole = text();
  for (std::size_t at = 0; at + 1 < whole.size(); ++at)
    for (const char other : {'0', '7', 'x', '\n', '\t'}) {
      if (whole[at] == other) continue;
      std::string damaged = whole;
      damaged[at] = other;
      write(damaged);
      EXPECT_NE(refusal(), "accepted") << at << " " << int(other);
      EXPECT_EQ(text(), damaged);
    }
}

TEST_F(Journals, NameADamagedLineAndWhatIsWhole) {
  std::string damaged = text();
  damaged[damaged.find("two")] = 'T';
  write(damaged);
  EXPECT_THAT(refusal(), ::testing::AllOf(::testing::HasSubstr("line 3 is damaged"),
                                          ::testing::HasSubstr("the other 2 lines are whole")));
}

TEST_F(Journals, AreOfOneWork) {
  EXPECT_THAT(refusal("# tripus test: version 2"), ::testing::HasSubstr("version 2"));
  EXPECT_THAT(refusal("# tripus other: version 1"), ::testing::HasSubstr("name another file"));
}

TEST_F(Journals, AreOfOneProcessAtATime) {
  const Journal journal(path_, kHeader);
  const pid_t child = fork();
  if (child == 0) {
    const std::string said = refusal();
    _exit(said.find("in use by process " + std::to_string(getppid())) != std::string::npos ||
                  said.find("in use by another process") != std::string::npos
              ? 0
              : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace tripus
