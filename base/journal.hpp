#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tripus {

/// A file that lines are added to while work goes on, by one process at a time.
///
/// A line is in the file whole or not at all, whatever happens to the disk; only what ends the
/// process in the midst of writing leaves a torn last line, without its end.
class AppendFile {
 public:
  /// Opens or makes the file and locks it. Throws InvalidInput "in use by process N" if another
  /// process has it, and what fail_on_file throws.
  explicit AppendFile(std::string path);
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;
  ~AppendFile();

  const std::string& path() const { return path_; }
  /// All there is in it. Throws IoError.
  std::string read() const;
  /// Cuts the file off after so many bytes. Throws IoError.
  void cut(std::uint64_t bytes);
  /// Throws IoError; nothing of the text is then in the file, and every later call throws too.
  void append(std::string_view text);
  /// Removes the file, still locked: whoever waits for it makes a new one.
  void remove();

 private:
  void lock();
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  int file_ = -1;
  std::uint64_t size_ = 0;
  int failure_ = 0;  ///< errno of the first write that failed, after which nothing is written
};

/// What is done of a long piece of work, so that it can go on after any interruption: a line for
/// each part, in a file whose first line says what the work depends on.
///
/// Every line carries its checksum: as the last key of a JSON object, or else after a tab. A torn
/// last line is cut off. A line that is damaged, and a file of other work, is refused by its place
/// and left as it is: what was believed would be wrong answers.
class Journal {
 public:
  /// Opens the journal `path` or begins it with `header`: a line that tells, up to its first colon,
  /// the kind of journal, and then what the lines depend on (version, options, inputs).
  /// Throws InvalidInput as said above, and what AppendFile throws.
  Journal(const std::string& path, const std::string& header);

  /// What the lines of earlier runs say, without checksums, in the order of the file.
  const std::vector<std::string>& lines() const { return lines_; }
  /// Where line `k` of lines() is, for messages: "journal "x", line 3".
  std::string place(std::size_t k) const;
  /// Adds a line, which must hold no line end. Throws IoError.
  void add(std::string_view line);
  void remove() { file_.remove(); }

 private:
  void read(const std::string& text, const std::string& header);

  AppendFile file_;
  std::vector<std::string> lines_;
};

/// A line with its checksum, as a journal holds it (without the line end).
std::string sealed(std::string_view line);
/// The line in it; false if the checksum is not its own.
bool unseal(std::string_view sealed_line, std::string& line);

}  // namespace tripus
