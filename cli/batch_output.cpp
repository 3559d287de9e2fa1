#include "cli/batch_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/checksum.hpp"
#include "base/error.hpp"
#include "cli/output.hpp"
#include "manifold/json_text.hpp"

namespace tripus::cli {
namespace {

constexpr std::string_view kMark = R"(, "checksum": ")";
constexpr std::size_t kDigits = 16;

std::string checksum_of(std::string_view answer, const std::string& asked) {
  return checksum_text(asked + std::string(answer));
}

/// {...} as {..., "checksum": "..."}.
std::string with_checksum(std::string_view answer, const std::string& asked) {
  std::string text(answer.substr(0, answer.size() - 1));
  text += kMark;
  return text + checksum_of(answer, asked) + "\"}";
}

bool has_checksum(std::string_view line) {
  const std::size_t tail = kMark.size() + kDigits + 2;
  return line.size() >= tail && line.substr(line.size() - tail, kMark.size()) == kMark;
}

/// Whether the checksum is the one that belongs to the answer.
bool is_sound(std::string_view line, const std::string& asked) {
  const std::size_t tail = kMark.size() + kDigits + 2;
  const std::string answer = std::string(line.substr(0, line.size() - tail)) + "}";
  return line.substr(line.size() - kDigits - 2, kDigits) == checksum_of(answer, asked);
}

/// Reads the answers of an earlier run.
class Answers {
 public:
  Answers(const std::string& path, const std::string& asked,
          const std::vector<topology::BatchLine>& lines, AnswersPerLine answers,
          const BatchOutput::Earlier& earlier)
      : path_(path), asked_(asked), lines_(lines), answers_(answers), earlier_(earlier) {}

  void read(std::string_view text) {
    std::size_t number = 1;
    for (std::size_t end; (end = text.find('\n', at_)) != std::string_view::npos; ++number) {
      const std::string_view line = text.substr(at_, end - at_);
      if (!nlohmann::json::accept(line)) refuse(number, "is no JSON object");
      // Those of a run without --resume, which have none, can only be the first ones.
      marked_ = marked_ || has_checksum(line);
      if (marked_ && !(has_checksum(line) && is_sound(line, asked_)))
        refuse(number, "was changed, or was answered with other options");
      answers_ == AnswersPerLine::kOne ? take_one(line, number) : take_any(line, number);
      at_ = end + 1;
    }
    if (answers_ == AnswersPerLine::kAnyNumber) at_ = last_begins_;
  }
  std::size_t bytes() const { return at_; }
  std::size_t answered() const { return answered_; }

 private:
  bool answers(std::string_view answer, std::size_t k) const {
    JsonText header;
    append_header(header, lines_[k].text);
    return answer.starts_with(std::string_view(header.data(), header.size()));
  }

  void take_one(std::string_view line, std::size_t number) {
    if (answered_ == lines_.size()) refuse(number, "is one more than the batch has lines");
    if (!answers(line, answered_))
      refuse(number, "is no answer of this version to line " +
                         std::to_string(lines_[answered_].line_number) + " of the batch, " +
                         quoted(lines_[answered_].text));
    const std::string problem = earlier_ ? earlier_(lines_[answered_], line) : "";
    if (!problem.empty()) refuse(number, problem);
    ++answered_;
  }

  /// `answered_` is the line of the batch that the last answers belong to.
  void take_any(std::string_view line, std::size_t number) {
    const bool first = line.find("\"cover\": 1,") != std::string_view::npos;
    std::size_t k = answered_;
    if (at_ > 0 && first) ++k;  // the same input may stand in the batch twice
    while (k < lines_.size() && !answers(line, k)) ++k;
    if (k == lines_.size())
      refuse(number, "is no answer of this version to a line of the batch in its order");
    if (k != answered_ || at_ == 0) last_begins_ = at_;
    answered_ = k;
  }

  [[noreturn]] void refuse(std::size_t number, const std::string& what) const {
    throw InvalidInput(fmt::format(
        "--resume {}: line {} {}; name the file of an interrupted run of the same batch",
        quoted(path_), number, what));
  }

  const std::string& path_;
  const std::string& asked_;
  const std::vector<topology::BatchLine>& lines_;
  const AnswersPerLine answers_;
  const BatchOutput::Earlier& earlier_;
  std::size_t at_ = 0, answered_ = 0, last_begins_ = 0;
  bool marked_ = false;
};

}  // namespace

BatchOutput::BatchOutput(const std::string& resume, const std::string& asked,
                         const std::vector<topology::BatchLine>& lines, AnswersPerLine answers,
                         const Earlier& earlier)
    : asked_(asked) {
  if (resume.empty()) return;
  file_.emplace(resume);
  const std::string text = file_->read();
  Answers known(resume, asked_, lines, answers, earlier);
  known.read(text);
  answered_ = known.answered();
  if (known.bytes() != text.size()) file_->cut(known.bytes());
}

void BatchOutput::write(std::string_view text) {
  if (file_) {
    std::string lines;
    for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string_view::npos;
         at = end + 1)
      lines += with_checksum(text.substr(at, end - at), asked_) + '\n';
    file_->append(lines);
  } else {
    write_output(text);
    flush_output();
  }
}

}  // namespace tripus::cli
