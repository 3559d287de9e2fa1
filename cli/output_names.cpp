#include "cli/output.hpp"

#include <filesystem>
#include <mutex>
#include <vector>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/output_file.hpp"

namespace tripus::cli {
namespace {

namespace fs = std::filesystem;

struct Declared {
  std::string option, given, target;
  std::string prefix;  ///< of the names, where `target` is a folder
};

struct Names {
  std::mutex mutex;
  std::vector<Declared> all;
};

Names& names() {
  static Names of_this_run;
  return of_this_run;
}

fs::path whole(const std::string& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(path, error);
  return error ? fs::path(path) : result;
}

/// Whether the file `target` is what standard input reads.
bool is_standard_input(const std::string& target) {
  struct stat in {
  }, out{};
  return ::fstat(STDIN_FILENO, &in) == 0 && ::stat(target.c_str(), &out) == 0 &&
         S_ISREG(in.st_mode) && in.st_ino == out.st_ino && in.st_dev == out.st_dev;
}

bool writes(const Declared& declared, const std::string& input) {
  if (declared.prefix.empty() && input == "-") return is_standard_input(declared.target);
  const fs::path path = whole(input);
  if (declared.prefix.empty()) return path == declared.target;
  return path.parent_path() == declared.target &&
         path.filename().string().starts_with(declared.prefix);
}

}  // namespace

void declare_output(const std::string& option, const std::string& path) {
  const OutputFile file(path);
  if (file.is_direct()) return;
  const std::lock_guard lock(names().mutex);
  for (const Declared& other : names().all) {
    if (other.target == file.target())
      throw InvalidInput(fmt::format("{} and {} would both write {}; give one of them another name",
                                     other.option, option, quoted(path)));
  }
  names().all.push_back({option, path, file.target(), {}});
}

void declare_output_folder(const std::string& path, const std::string& prefix) {
  const std::lock_guard lock(names().mutex);
  names().all.push_back({"-o", path, whole(path + "/.").string(), prefix});
  std::string& target = names().all.back().target;
  while (target.size() > 1 && target.ends_with('/')) target.pop_back();
}

void require_not_written(const std::string& input) {
  const std::lock_guard lock(names().mutex);
  for (const Declared& declared : names().all) {
    if (!writes(declared, input) && !writes(declared, input.substr(0, input.rfind('#')))) continue;
    throw InvalidInput(fmt::format("{} {} would write over {}, which is read; name another file",
                                   declared.option, quoted(declared.given),
                                   input == "-" ? "standard input" : quoted(input)));
  }
}

}  // namespace tripus::cli
