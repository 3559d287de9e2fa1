#include "base/output_file.hpp"

#include <atomic>
#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/system_error.hpp"

namespace tripus {
namespace {

namespace fs = std::filesystem;

/// A name beside the target that no other file has, neither of this process nor of another.
std::string draft_name(const fs::path& target) {
  static std::atomic<unsigned> number{0};
  // Long names are cut: the draft's must not be longer than a name may be.
  const std::string name = "." + target.filename().string().substr(0, 200) + "." +
                           std::to_string(getpid()) + "-" + std::to_string(number++) + ".draft";
  return (target.parent_path() / name).string();
}

/// Follows symbolic links, also to a file that is not there yet.
fs::path followed(fs::path path) {
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(path, error); ++links) {
    const fs::path to = fs::read_symlink(path, error);
    if (error) break;
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path : whole;
}

/// The way to an open file that has no name.
std::string way_to(int file) { return "/proc/self/fd/" + std::to_string(file); }

}  // namespace

void OutputFile::fail() {
  const int error = errno != 0 ? errno : EIO;
  discard();
  fail_on_file("cannot write", path_, error);
}

void OutputFile::discard() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
  if (!draft_.empty()) ::unlink(draft_.c_str());
  draft_.clear();
}

void OutputFile::begin_draft() {
#ifdef O_TMPFILE
  // A file without a name goes with its process, also when that is killed.
  const fs::path folder = fs::path(target_).parent_path();
  file_ = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file_ >= 0 && ::access(way_to(file_).c_str(), W_OK) == 0) return;
  discard();
#endif
  draft_ = draft_name(target_);
  file_ = ::open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ >= 0) return;
  draft_.clear();
  fail();
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  // The system would write to what stands before it.
  if (path_.find('\0') != std::string::npos)
    throw InvalidInput("cannot write " + tripus::quoted(path_) + ": the name holds a zero byte");
  target_ = followed(path_).string();
  struct stat there {};
  if (::stat(target_.c_str(), &there) == 0) {
    direct_ = !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
    errno = S_ISDIR(there.st_mode) ? EISDIR : EACCES;
    const bool writable = (there.st_mode & 0222) != 0 && ::access(target_.c_str(), W_OK) == 0;
    if (S_ISDIR(there.st_mode) || !writable) fail();
  } else if (errno != ENOENT) {
    fail();
  }
  if (direct_) return;
  begin_draft();
  discard();
}

OutputFile::~OutputFile() {
  stream_.close();
  discard();
}

std::ostream& OutputFile::open() {
  errno = 0;
  if (direct_) {
    stream_.open(target_, std::ios::binary);
  } else {
    begin_draft();
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(file_, old.st_mode & 07777);
    stream_.open(draft_.empty() ? way_to(file_) : draft_, std::ios::binary | std::ios::trunc);
  }
  if (!stream_) fail();
  return stream_;
}

void OutputFile::close() {
  errno = 0;
  stream_.close();
  if (!stream_) fail();
  if (direct_) return;
  // A rename that reaches the disk before what was written would leave an empty file.
  if (::fsync(file_) != 0 && errno != EINVAL) fail();  // EINVAL: a file system without
  if (draft_.empty()) {
    draft_ = draft_name(target_);
    if (::linkat(AT_FDCWD, way_to(file_).c_str(), AT_FDCWD, draft_.c_str(), AT_SYMLINK_FOLLOW) != 0)
      fail();
  }
  if (::rename(draft_.c_str(), target_.c_str()) != 0) fail();
  draft_.clear();
  discard();
}

void write_file(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.open() << text;
  file.close();
}

}  // namespace tripus
