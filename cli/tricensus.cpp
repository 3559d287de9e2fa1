#include "cli/tricensus.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "cli/interrupt.hpp"
#include "topology/isosig.hpp"
#include "topology/triangulation.hpp"

extern char** environ;

namespace tripus::cli {
namespace {

constexpr const char* kProgram = "tricensus";

/// A folder that is removed with all in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tripus-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw IoError(
          fmt::format("cannot make a folder {}: {}", tripus::quoted(name), std::strerror(errno)));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Starts the program with its chatter thrown away; the child's number.
pid_t start(const std::vector<std::string>& arguments) {
  std::vector<std::string> copies = arguments;
  std::vector<char*> pointers;
  for (std::string& each : copies) pointers.push_back(each.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawnp(&child, kProgram, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT)
    throw Unsupported(
        "Regina's program tricensus is not installed; on Debian: apt install regina-normal, or "
        "leave --engine out");
  if (error != 0) throw IoError(fmt::format("cannot start {}: {}", kProgram, std::strerror(error)));
  return child;
}

/// Waits for the child, and ends it where the work is to end. False if it was ended.
bool wait_for(pid_t child) {
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR)
      throw IoError(fmt::format("lost {}: {}", kProgram, std::strerror(errno)));
    if (interrupt_requested()) {
      kill(child, SIGKILL);
      while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw IoError(fmt::format("{} failed", kProgram));
  return true;
}

}  // namespace

bool for_each_of_tricensus(std::size_t tetrahedra, const topology::EnumerationChoice& choice,
                           const std::function<void(const std::string&)>& take) {
  const TemporaryFolder folder;
  const std::string list = (folder.path() / "list").string();
  std::vector<std::string> arguments{kProgram, fmt::format("--tetrahedra={}", tetrahedra),
                                     "--internal", "--sigs"};
  using topology::Orientability;
  if (choice.orientability == Orientability::kOrientable) arguments.push_back("--orientable");
  if (choice.orientability == Orientability::kNonOrientable) arguments.push_back("--nonorientable");
  arguments.push_back(list);
  const pid_t child = start(arguments);
  if (!wait_for(child)) return false;
  std::ifstream in(list);
  if (!in) throw IoError(fmt::format("{} wrote no list", kProgram));
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (interrupt_requested()) return false;
    const topology::Triangulation triangulation(topology::decode_isosig(line));
    if (topology::is_chosen(triangulation, choice)) take(topology::isosig(triangulation.gluings()));
  }
  return true;
}

}  // namespace tripus::cli
