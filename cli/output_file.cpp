#include "cli/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"

namespace tripus::cli {
namespace {

[[noreturn]] void fail(const std::string& path) {
  throw InvalidInput("cannot write " + quoted(path) + ": " + std::strerror(errno));
}

}  // namespace

std::string problem_of_name(const std::string& name) {
  return name.empty() ? "the name of the file is empty" : "";
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  std::error_code unknown;
  made_here_ = !std::filesystem::exists(path_, unknown);
  errno = 0;
  if (!std::ofstream(path_, std::ios::app)) fail(path_);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (made_here_ && !closed_) std::filesystem::remove(path_, ignored);
}

std::ostream& OutputFile::open() {
  errno = 0;
  stream_.open(path_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail(path_);
  return stream_;
}

void OutputFile::close() {
  stream_.close();
  if (!stream_) fail(path_);
  closed_ = true;
}

}  // namespace tripus::cli
