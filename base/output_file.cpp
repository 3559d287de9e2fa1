#include "base/output_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.hpp"

namespace tripus {
namespace {

namespace fs = std::filesystem;

/// A name beside the target that no other file has, neither of this process nor of another.
std::string draft_name(const fs::path& target) {
  static std::atomic<unsigned> number{0};
  const std::string name = "." + target.filename().string() + "." + std::to_string(getpid()) + "-" +
                           std::to_string(number++) + ".draft";
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

/// Creates the file, which must not be there, and leaves the reason in errno otherwise.
bool create(const std::string& path, mode_t mode) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  return file >= 0 && ::close(file) == 0;
}

bool write_through(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool synced = ::fsync(file) == 0 || errno == EINVAL;  // EINVAL: a file system without
  return (::close(file) == 0) && synced;
}

}  // namespace

std::string OutputFile::what_failed() const {
  return "cannot write " + quoted(path_) + ": " + std::strerror(errno);
}

void OutputFile::fail() {
  const std::string what = what_failed();
  remove_draft();
  throw IoError(what);
}

void OutputFile::remove_draft() {
  if (!draft_.empty()) ::unlink(draft_.c_str());
  draft_.clear();
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  target_ = followed(path_).string();
  struct stat there {};
  if (::stat(target_.c_str(), &there) == 0) {
    direct_ = !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
    errno = S_ISDIR(there.st_mode) ? EISDIR : EACCES;
    const bool writable = (there.st_mode & 0222) != 0 && ::access(target_.c_str(), W_OK) == 0;
    if (S_ISDIR(there.st_mode) || !writable) throw InvalidInput(what_failed());
  } else if (errno != ENOENT) {
    throw InvalidInput(what_failed());
  }
  if (direct_) return;
  draft_ = draft_name(target_);
  if (!create(draft_, 0666)) {
    draft_.clear();
    throw InvalidInput(what_failed());
  }
  remove_draft();
}

OutputFile::~OutputFile() {
  stream_.close();
  remove_draft();
}

std::ostream& OutputFile::open() {
  errno = 0;
  if (direct_) {
    stream_.open(target_, std::ios::binary);
  } else {
    draft_ = draft_name(target_);
    if (!create(draft_, 0666)) fail();
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::chmod(draft_.c_str(), old.st_mode & 07777);
    stream_.open(draft_, std::ios::binary | std::ios::trunc);
  }
  if (!stream_) fail();
  return stream_;
}

void OutputFile::close() {
  errno = 0;
  stream_.close();
  if (!stream_) fail();
  if (direct_) return;
  if (!write_through(draft_) || ::rename(draft_.c_str(), target_.c_str()) != 0) fail();
  draft_.clear();
}

void write_file(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.open() << text;
  file.close();
}

}  // namespace tripus
