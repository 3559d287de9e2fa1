#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "meshing/tetrahedralize.hpp"
#include "meshing/validate_tetrahedra.hpp"
#include "tests/support/sample_surfaces.hpp"

// The mesher's process in bad company: scripts that stand for a TetGen that crashes, hangs, babbles
// or is missing. Each is a clear error, and no process is left behind.

namespace tripus::meshing {
namespace {

/// TRIPUS_TETGEN names a script with this body for the length of a test.
class FalseTetgen {
 public:
  explicit FalseTetgen(const std::string& body, bool may_run = true) {
    std::string pattern = (std::filesystem::temp_directory_path() / "tripus-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    const auto script = folder_ / "tetgen";
    std::ofstream(script) << "#!/bin/sh\n" << body << "\n";
    if (may_run) std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    setenv("TRIPUS_TETGEN", script.c_str(), 1);
  }
  ~FalseTetgen() {
    unsetenv("TRIPUS_TETGEN");
    std::filesystem::remove_all(folder_);
  }

 private:
  std::filesystem::path folder_;
};

const Region& region() {
  static const Region kRegion = require_valid(testing::box_surface(0, 1, 10));
  return kRegion;
}

template <class Failure>
std::string message_of(const TetrahedralizeOptions& options = {}) {
  try {
    tetrahedralize(region(), options);
  } catch (const Failure& error) {
    // Every child has been waited for.
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return "";
}

/// So little that there is no way but TetGen's.
TetrahedralizeOptions little_memory() {
  TetrahedralizeOptions options;
  options.memory_limit = 1 << 10;
  return options;
}

TEST(MeshingProcess, Crashes) {
  const FalseTetgen tetgen("kill -SEGV $$");
  EXPECT_NE(message_of<IoError>(little_memory()).find("was ended by signal 11"), std::string::npos);
}

TEST(MeshingProcess, EndsEarly) {
  const FalseTetgen tetgen("echo first; echo last words >&2; exit 7");
  EXPECT_NE(message_of<IoError>(little_memory())
                .find("ended with status 7, its last words \"last words\""),
            std::string::npos);
}

TEST(MeshingProcess, IsNotNeeded) {
  for (const char* failure : {"kill -SEGV $$", "exit 7", "echo babble"}) {
    const FalseTetgen tetgen(failure);
    const Solid solid = require_valid(tetrahedralize(region()));
    EXPECT_EQ(solid.boundary_genera, std::vector<int>{0}) << failure;
  }
}

TEST(MeshingProcess, ClosesItsEndAndLivesOn) {
  const FalseTetgen tetgen("exec <&-; exec sleep 1000");
  EXPECT_NE(message_of<IoError>(little_memory()).find("was ended by signal 9"), std::string::npos);
}

TEST(MeshingProcess, IsNotAskedForMoreThanThereIsRoomFor) {
  TetrahedralizeOptions options;
  options.max_volume = 1e-300;
  EXPECT_NE(message_of<InvalidInput>(options).find("allow larger ones"), std::string::npos);
}

TEST(MeshingProcess, Hangs) {
  const FalseTetgen tetgen("exec sleep 1000");
  TetrahedralizeOptions options;
  options.time_limit = 0.2;
  EXPECT_NE(message_of<Unsupported>(options).find("was not done after"), std::string::npos);
}

TEST(MeshingProcess, IsStopped) {
  const FalseTetgen tetgen("exec sleep 1000");
  std::atomic<bool> stop = false;
  TetrahedralizeOptions options;
  options.stop = &stop;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    stop = true;
  });
  EXPECT_EQ(message_of<Stopped>(options), "interrupted");
  later.join();
}

TEST(MeshingProcess, IsInterruptedByItself) {
  const FalseTetgen tetgen("kill -INT $$");
  message_of<Stopped>();
}

TEST(MeshingProcess, IsMissing) {
  const FalseTetgen tetgen("", false);
  EXPECT_NE(message_of<Unsupported>().find("TRIPUS_TETGEN names"), std::string::npos);
}

TEST(MeshingProcess, RunsOutOfMemory) {
#if defined(TRIPUS_SANITIZED)
  GTEST_SKIP() << "address space has no limit under the sanitizer";
#endif
  TetrahedralizeOptions options;
  options.memory_limit = 64 << 20;
  options.tetrahedra = 3'000'000;
  const std::string message = message_of<Unsupported>(options);
  EXPECT_TRUE(message.find("memory") != std::string::npos ||
              message.find("signal") != std::string::npos)
      << message;
}

TEST(MeshingProcess, FewFilesAreLeftOpen) {
  const auto open_files = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"),
                         std::filesystem::directory_iterator());
  };
  tetrahedralize(region());
  const auto before = open_files();
  for (int i = 0; i < 5; ++i) tetrahedralize(region());
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace tripus::meshing
