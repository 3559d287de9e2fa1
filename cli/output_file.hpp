#pragma once

#include <fstream>
#include <string>

namespace tripus::cli {

/// What is wrong with the name of a file to write, as a check of an option: it must not be empty.
std::string problem_of_name(const std::string& name);

/// A file that a verb will write at the end of its work.
class OutputFile {
 public:
  /// Tries whether it can be written, so that this is not found out after the work; leaves a file
  /// that is there as it is. Throws InvalidInput, naming the file and the system's reason.
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes what the trial left, if nothing was written.
  ~OutputFile();

  const std::string& path() const { return path_; }
  /// Empties it for writing.
  std::ostream& open();
  /// Throws InvalidInput if not everything could be written.
  void close();

 private:
  std::string path_;
  std::ofstream stream_;
  bool made_here_ = false;
  bool closed_ = false;
};

}  // namespace tripus::cli
