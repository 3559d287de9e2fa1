#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/journal.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {

/// How many answers a line of a batch has.
enum class AnswersPerLine { kOne, kAnyNumber };

/// Where the answers of a batch go: to standard output, or after those of an earlier run that are
/// in a file already (--resume FILE).
class BatchOutput {
 public:
  /// Told of an answer that is there already; says what keeps it from being used, or nothing.
  using Earlier =
      std::function<std::string(const topology::BatchLine& line, std::string_view answer)>;

  /// With a file: reads which lines have their answers there, as JSON objects, one a line, in the
  /// order of the batch. A torn last line is cut off; of lines with any number of answers the last
  /// that has some is answered anew, since more may belong to it. Each answer ends with a checksum
  /// of itself and of `asked`, the options on which it depends; one without, such as standard
  /// output in a file, is taken as it is.
  /// Throws InvalidInput, naming the line of the file, for one that is no answer to its line of the
  /// batch by this version, or does not have its checksum; and what AppendFile throws.
  BatchOutput(const std::string& resume, const std::string& asked,
              const std::vector<topology::BatchLine>& lines,
              AnswersPerLine answers = AnswersPerLine::kOne, const Earlier& earlier = {});

  /// How many lines of the batch need no answer any more.
  std::size_t answered() const { return answered_; }
  /// Whole lines, out at once. Throws IoError.
  void write(std::string_view text);

 private:
  std::optional<AppendFile> file_;
  std::string asked_;
  std::size_t answered_ = 0;
};

}  // namespace tripus::cli
