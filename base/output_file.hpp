#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace tripus {

/// A file that is written at the end of some work: whole or not at all.
///
/// What is written goes to a draft beside the file, which takes the file's name when it is closed.
/// Where the system knows files without names the draft is one, and nothing is left of a process
/// that was killed.
/// So at that name there is at any time the old file or the new one, each whole, whatever happens.
/// Pipes and devices are written directly. A symbolic link stays, its target is replaced; the
/// permissions of an old file are kept, and one that nobody may write is not replaced.
class OutputFile {
 public:
  /// Tries whether the file can be written, so that this is not found out after the work; leaves
  /// nothing behind. Throws InvalidInput, naming the file and the system's reason; IoError for a
  /// full disk and the like.
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes a draft that was not closed.
  ~OutputFile();

  const std::string& path() const { return path_; }
  /// Whether both names are names of one file.
  bool is_same_as(const OutputFile& other) const { return target_ == other.target_; }
  /// The file that is written, with links followed.
  const std::string& target() const { return target_; }
  /// Whether it is a pipe or a device, of which nothing is lost by being written to twice.
  bool is_direct() const { return direct_; }
  /// Begins the draft. Throws IoError.
  std::ostream& open();
  /// Throws IoError if not everything could be written; the old file is then still there.
  void close();

 private:
  /// Throws what errno deserves.
  [[noreturn]] void fail();
  void begin_draft();
  void discard();

  std::string path_;    // as given, for messages
  std::string target_;  // with links followed
  std::string draft_;   // empty while it has no name
  int file_ = -1;       // the draft
  bool direct_ = false;
  std::ofstream stream_;
};

/// Writes a whole file, as OutputFile does.
void write_file(const std::string& path, std::string_view text);

}  // namespace tripus
