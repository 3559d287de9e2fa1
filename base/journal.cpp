#include "base/journal.hpp"

#include <cerrno>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "base/system_error.hpp"

namespace tripus {
namespace {

constexpr std::string_view kJsonKey = ", \"checksum\": \"";
constexpr std::string_view kJsonEnd = "\"}";
constexpr std::size_t kDigits = 16;

/// The process that has locked a file; empty if the system does not tell.
std::string holder_of(int file) {
  struct stat there {};
  if (::fstat(file, &there) != 0) return {};
  const std::string inode = ":" + std::to_string(there.st_ino);
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    // "1: FLOCK  ADVISORY  WRITE 1234 08:01:5678 0 EOF"
    std::istringstream fields(line);
    std::string number, kind, mode, access, process, place;
    fields >> number >> kind >> mode >> access >> process >> place;
    if (kind == "FLOCK" && place.ends_with(inode) && process != "0") return process;
  }
  return {};
}

/// Whether the name still leads to the open file: another process may have removed it meanwhile.
bool is_at(int file, const std::string& path) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

}  // namespace

void AppendFile::fail(const char* what) const { fail_on_file(what, path_, errno); }

void AppendFile::lock() {
  for (;;) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) fail("cannot write");
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) return;  // a file system without locks
      const std::string holder = holder_of(file_);
      throw InvalidInput(tripus::quoted(path_) + " is in use by " +
                         (holder.empty() ? "another process" : "process " + holder) +
                         "; wait for its end, or choose another file");
    }
    if (is_at(file_, path_)) return;
    ::close(file_);
  }
}

AppendFile::AppendFile(std::string path) : path_(std::move(path)) {
  try {
    lock();
    struct stat there {};
    if (::fstat(file_, &there) != 0) fail("cannot read");
    if (!S_ISREG(there.st_mode)) throw InvalidInput(tripus::quoted(path_) + " is no ordinary file");
    size_ = static_cast<std::uint64_t>(there.st_size);
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
}

AppendFile::~AppendFile() { ::close(file_); }

std::string AppendFile::read() const {
  std::string text(size_, '\0');
  std::size_t got = 0;
  while (got < text.size()) {
    const ssize_t bytes = ::pread(file_, text.data() + got, text.size() - got, off_t(got));
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes < 0) fail("cannot read");
    if (bytes == 0) break;
    got += static_cast<std::size_t>(bytes);
  }
  text.resize(got);
  return text;
}

void AppendFile::cut(std::uint64_t bytes) {
  if (::ftruncate(file_, static_cast<off_t>(bytes)) != 0) fail("cannot write");
  size_ = bytes;
}

void AppendFile::append(std::string_view text) {
  if (failure_ != 0) fail_on_file("cannot write", path_, failure_);
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t bytes = ::write(file_, rest.data(), rest.size());
    if (bytes < 0 && errno == EINTR) continue;
    if (bytes < 0) {
      failure_ = errno;
      // What is there of the text would be a torn line in the midst of others.
      [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(size_));
      fail_on_file("cannot write", path_, failure_);
    }
    rest.remove_prefix(static_cast<std::size_t>(bytes));
  }
  size_ += text.size();
}

void AppendFile::remove() { ::unlink(path_.c_str()); }

std::string sealed(std::string_view line) {
  std::string out(line);
  if (line.ends_with('}')) {
    out.pop_back();
    return out.append(kJsonKey).append(checksum_text(line)).append(kJsonEnd);
  }
  return out.append("\t").append(checksum_text(line));
}

bool unseal(std::string_view sealed_line, std::string& line) {
  const bool json = sealed_line.ends_with(kJsonEnd);
  const std::string_view before = json ? kJsonKey : "\t";
  const std::string_view after = json ? kJsonEnd : "";
  const std::size_t seal = before.size() + kDigits + after.size();
  if (sealed_line.size() < seal) return false;
  line = sealed_line.substr(0, sealed_line.size() - seal);
  if (json) line += '}';
  return sealed(line) == sealed_line;
}

Journal::Journal(const std::string& path, const std::string& header) : file_(path) {
  read(file_.read(), header);
}

std::string Journal::place(std::size_t k) const {
  return "the journal " + quoted(file_.path()) + ", line " + std::to_string(k + 2);
}

void Journal::read(const std::string& text, const std::string& header) {
  const std::string name = "the journal " + quoted(file_.path());
  const std::string first = sealed(header) + '\n';
  std::string line;
  const std::size_t end = text.find('\n');
  // A run that ended while it began its journal has left a part of the first line.
  if (end == std::string::npos && first.starts_with(text)) {
    file_.cut(0);
    file_.append(first);
    return;
  }
  const std::string begin = header.substr(0, header.find(':') + 1);
  if (!text.starts_with(begin))
    throw InvalidInput(name + ": line 1 is not the first of such a journal (\"" + begin +
                       " ...\"); name another file, or remove it to begin anew");
  if (end == std::string::npos || !unseal(text.substr(0, end), line))
    throw InvalidInput(name +
                       ": line 1, which says what it is of, is damaged; remove the file to "
                       "begin anew");
  if (line != header)
    throw InvalidInput(name + " is of other inputs, options or version: it says " +
                       quoted(line, 400) + ", this run is " + quoted(header, 400) +
                       "; name another file, or remove it to begin anew");
  std::vector<std::size_t> damaged;
  std::size_t number = 2, at = end + 1;
  for (std::size_t stop; (stop = text.find('\n', at)) != std::string::npos; at = stop + 1) {
    if (unseal(std::string_view(text).substr(at, stop - at), line)) {
      lines_.push_back(line);
    } else {
      damaged.push_back(number);
    }
    ++number;
  }
  if (!damaged.empty()) {
    const bool one = damaged.size() == 1;
    throw InvalidInput(
        name + ", line " + std::to_string(damaged.front()) + " is damaged" +
        (one ? "" : ", and " + std::to_string(damaged.size() - 1) + " more") + "; the other " +
        std::to_string(lines_.size()) + " lines are whole (" + std::to_string(damaged.front() - 2) +
        " before it): remove what is damaged, and the same command goes on with them");
  }
  if (at != text.size()) file_.cut(at);
}

void Journal::add(std::string_view line) { file_.append(sealed(line) + '\n'); }

}  // namespace tripus
