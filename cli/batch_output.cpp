#include "cli/batch_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/output.hpp"
#include "cli/output_names.hpp"
#include "manifold/json_text.hpp"

namespace tripus::cli {
namespace {

/// Reads the answers of an earlier run.
class Answers {
 public:
  Answers(const std::string& path, const std::vector<topology::BatchLine>& lines,
          AnswersPerLine answers, const BatchOutput::Earlier& earlier)
      : path_(path), lines_(lines), answers_(answers), earlier_(earlier) {}

  void read(std::string_view text) {
    std::size_t number = 1;
    for (std::size_t end; (end = text.find('\n', at_)) != std::string_view::npos; ++number) {
      const std::string_view line = text.substr(at_, end - at_);
      if (!nlohmann::json::accept(line)) refuse(number, "is no JSON object");
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
  const std::vector<topology::BatchLine>& lines_;
  const AnswersPerLine answers_;
  const BatchOutput::Earlier& earlier_;
  std::size_t at_ = 0, answered_ = 0, last_begins_ = 0;
};

}  // namespace

BatchOutput::BatchOutput(const std::string& resume, const std::vector<topology::BatchLine>& lines,
                         AnswersPerLine answers, const Earlier& earlier) {
  if (resume.empty()) return;
  file_.emplace(resume);
  const std::string text = file_->read();
  Answers known(resume, lines, answers, earlier);
  known.read(text);
  answered_ = known.answered();
  if (known.bytes() != text.size()) file_->cut(known.bytes());
}

void BatchOutput::write(std::string_view text) {
  if (file_) {
    file_->append(text);
  } else {
    write_output(text);
    flush_output();
  }
}

}  // namespace tripus::cli
