#include "cli/batch.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <vector>

#include <fmt/format.h>

#include "base/threads.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "manifold/load.hpp"

namespace tripus::cli {
namespace {

/// Consecutive lines answered by one thread in one go: enough that handing them over costs nothing,
/// few enough that the answers flow and that every thread has its share of a short batch.
std::size_t chunk_size(std::size_t lines, unsigned threads) {
  return std::clamp<std::size_t>(lines / (8 * std::size_t{threads}), 1, 64);
}

/// The answers of one chunk, and whether its thread is through with it.
struct Chunk {
  std::string text;
  std::string messages;
  std::size_t answered = 0;
  int status = kSuccess;
  bool done = false;
};

class Batch {
 public:
  Batch(const std::vector<topology::BatchLine>& lines, BatchOutput& output, unsigned threads,
        const std::function<Answer(const topology::BatchLine&)>& answer)
      : lines_(lines),
        first_(output.answered()),
        output_(output),
        answer_(answer),
        chunk_size_(chunk_size(lines.size() - first_, threads)),
        chunks_((lines.size() - first_ + chunk_size_ - 1) / chunk_size_),
        threads_(unsigned(std::min<std::size_t>(threads, chunks_.size()))),
        running_(threads_) {}

  /// Writes every answer in order, up to the first that is not there.
  int run(const BatchOptions& options) {
    const auto workers = start_threads(threads_, [this] { work(); });
    const EndWork end_with_this(*this);
    if (workers.size() < threads_) no_more_than(workers.size());
    Progress progress(!options.quiet);
    std::size_t answered = first_;
    int status = kSuccess;
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      set_last_words(rest_text(answered, options));
      const Chunk chunk = wait_for(k, progress, answered);
      answered += chunk.answered;
      output_.write(chunk.text);
      write_message(chunk.messages);
      if (chunk.status == kInternalFailure) status = kInternalFailure;
      if (chunk.answered < lines_of(k)) break;
    }
    if (answered == lines_.size()) return status;
    write_message(fmt::format("tripus: {}{}\n", stop_text(), rest_text(answered, options)));
    return kNoAnswer;
  }

 private:
  /// An exception must not wait for the answers to all lines.
  struct EndWork {
    explicit EndWork(Batch& of) : batch(of) {}
    EndWork(const EndWork&) = delete;
    EndWork& operator=(const EndWork&) = delete;
    ~EndWork() { batch.ended_ = true; }
    Batch& batch;
  };

  /// What an interruption leaves.
  std::string rest_text(std::size_t answered, const BatchOptions& options) const {
    return fmt::format(": {} of {} inputs answered, none after these; {}", answered, lines_.size(),
                       options.resume.empty()
                           ? "--json --resume FILE, with these answers in FILE, goes on from there"
                           : "the same command goes on from there");
  }

  std::size_t lines_of(std::size_t k) const {
    return std::min(chunk_size_, lines_.size() - first_ - k * chunk_size_);
  }

  /// Where the system gave no thread at all, the work is done here.
  void no_more_than(std::size_t started) {
    {
      const std::lock_guard lock(mutex_);
      running_ -= unsigned(threads_ - started);
      if (started == 0) running_ = 1;
    }
    if (started == 0) work();
  }

  bool stopped() const { return ended_ || interrupt_requested(); }

  Chunk wait_for(std::size_t k, Progress& progress, std::size_t answered) {
    std::unique_lock lock(mutex_);
    const auto ready = [&] { return chunks_[k].done || running_ == 0 || failure_; };
    while (!ready_.wait_for(lock, std::chrono::milliseconds(100), ready)) {
      if (progress.due()) progress.show(fmt::format("{} of {} inputs", answered, lines_.size()));
    }
    if (progress.due()) progress.show(fmt::format("{} of {} inputs", answered, lines_.size()));
    if (failure_) std::rethrow_exception(failure_);
    return std::move(chunks_[k]);
  }

  void work() {
    std::exception_ptr failure;
    try {
      for (std::size_t k = next_++; k < chunks_.size() && !stopped(); k = next_++) {
        Chunk chunk = answer_chunk(k);
        const std::lock_guard lock(mutex_);
        chunks_[k] = std::move(chunk);
        ready_.notify_one();
      }
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (failure && !failure_) failure_ = failure;
    --running_;
    ready_.notify_one();
  }

  Chunk answer_chunk(std::size_t k) const {
    Chunk chunk;
    chunk.done = true;
    const std::size_t begin = first_ + k * chunk_size_;
    for (std::size_t i = begin; i < begin + lines_of(k) && !stopped(); ++i) {
      const Answer answer = answer_(lines_[i]);
      if (stopped()) break;  // the answer may be "unresolved" by the interruption alone
      ++chunk.answered;
      chunk.status = std::max(chunk.status, answer.status);
      if (!answer.text.empty()) chunk.text += answer.text + '\n';
      if (!answer.message.empty())
        chunk.messages +=
            fmt::format("tripus: line {}: {}\n", lines_[i].line_number, answer.message);
    }
    return chunk;
  }

  const std::vector<topology::BatchLine>& lines_;
  const std::size_t first_;
  BatchOutput& output_;
  const std::function<Answer(const topology::BatchLine&)>& answer_;
  const std::size_t chunk_size_;
  std::vector<Chunk> chunks_;
  const unsigned threads_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> ended_{false};
  std::mutex mutex_;
  std::condition_variable ready_;
  std::exception_ptr failure_;
  unsigned running_;
};

}  // namespace

int run_batch(const BatchOptions& options,
              const std::function<Answer(const topology::BatchLine&)>& answer) {
  if (!options.resume.empty()) declare_output("--resume", options.resume);
  require_not_written(options.file);
  const std::vector<topology::BatchLine> lines = read_batch_file(options.file);
  BatchOutput output(options.resume, options.asked, lines, AnswersPerLine::kOne, options.earlier);
  return Batch(lines, output, thread_count(options.threads), answer).run(options);
}

}  // namespace tripus::cli
