#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/output_file.hpp"

namespace tripus {
namespace {

class OutputFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "tripus-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    path_ = (folder_ / "file").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }
  long names() const {
    return std::distance(std::filesystem::directory_iterator(folder_),
                         std::filesystem::directory_iterator());
  }

  std::filesystem::path folder_;
  std::string path_;
};

TEST_F(OutputFiles, AreOldUntilTheyAreClosed) {
  write_file(path_, "old");
  OutputFile file(path_);
  file.open() << "new" << std::flush;
  EXPECT_EQ(text(), "old");
  file.close();
  EXPECT_EQ(text(), "new");
  EXPECT_EQ(names(), 1);
}

TEST_F(OutputFiles, HaveNoZeroByteInTheirNames) {
  EXPECT_THROW(write_file(path_ + std::string(1, '\0') + ".json", "new"), InvalidInput);
  EXPECT_EQ(names(), 0);
}

TEST_F(OutputFiles, LeaveNothingWhereTheyAreNotClosed) {
  {
    OutputFile file(path_);
    file.open() << "new" << std::flush;
  }
  EXPECT_EQ(names(), 0);
}

TEST_F(OutputFiles, KeepPermissionsAndLinks) {
  namespace fs = std::filesystem;
  write_file(path_, "old");
  fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write);
  const auto link = folder_ / "link";
  fs::create_symlink("file", link);
  write_file(link.string(), "new");
  EXPECT_EQ(text(), "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(fs::status(path_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFiles, TellABadNameFromABadMachine) {
  EXPECT_THROW(write_file((folder_ / "no" / "file").string(), "x"), InvalidInput);
  EXPECT_THROW(write_file(folder_.string(), "x"), InvalidInput);
  EXPECT_THROW(write_file("/dev/full", "x"), IoError);
  write_file(path_, "old");
  std::filesystem::permissions(path_, std::filesystem::perms::owner_read);
  EXPECT_THROW(write_file(path_, "x"), InvalidInput);
  EXPECT_EQ(text(), "old");
}

}  // namespace
}  // namespace tripus
