#include "cli/batch.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "cli/exit_status.hpp"
#include "cli/input.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {
namespace {

/// Consecutive lines answered by one thread in one go: large enough that handing them over costs
/// nothing, small enough that the answers flow.
constexpr std::size_t kChunk = 64;

/// The answers of one chunk, and whether its thread is through with it.
struct Chunk {
  std::string text;
  std::string messages;
  std::size_t answered = 0;
  bool done = false;
};

class Batch {
 public:
  Batch(std::vector<topology::BatchLine> lines,
        const std::function<Answer(const std::string&)>& answer)
      : lines_(std::move(lines)), answer_(answer), chunks_((lines_.size() + kChunk - 1) / kChunk) {}

  /// Writes every answer in order; an interrupted run writes those that were ready.
  int run(unsigned threads, bool quiet) {
    running_ = threads;
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < threads; ++i) workers.emplace_back([this] { work(); });
    Progress progress(!quiet);
    std::size_t answered = 0;
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      const Chunk chunk = wait_for(k, progress, answered);
      answered += chunk.answered;
      write_output(chunk.text);
      write_message(chunk.messages);
    }
    if (answered == lines_.size()) return kSuccess;
    write_message(fmt::format("interrupted: {} of {} inputs answered\n", answered, lines_.size()));
    return kNoAnswer;
  }

 private:
  Chunk wait_for(std::size_t k, Progress& progress, std::size_t answered) {
    std::unique_lock lock(mutex_);
    const auto ready = [&] { return chunks_[k].done || running_ == 0; };
    while (!ready_.wait_for(lock, std::chrono::milliseconds(100), ready)) {
      if (progress.due()) progress.show(fmt::format("{} of {} inputs", answered, lines_.size()));
    }
    if (progress.due()) progress.show(fmt::format("{} of {} inputs", answered, lines_.size()));
    return std::move(chunks_[k]);
  }

  void work() {
    for (std::size_t k = next_++; k < chunks_.size() && !interrupt_requested(); k = next_++) {
      Chunk chunk = answer_chunk(k);
      const std::lock_guard lock(mutex_);
      chunks_[k] = std::move(chunk);
      ready_.notify_one();
    }
    const std::lock_guard lock(mutex_);
    --running_;
    ready_.notify_one();
  }

  Chunk answer_chunk(std::size_t k) const {
    Chunk chunk;
    chunk.done = true;
    const std::size_t end = std::min((k + 1) * kChunk, lines_.size());
    for (std::size_t i = k * kChunk; i < end && !interrupt_requested(); ++i) {
      const Answer answer = answer_(lines_[i].text);
      ++chunk.answered;
      if (!answer.text.empty()) chunk.text += answer.text + '\n';
      if (!answer.message.empty())
        chunk.messages += fmt::format("line {}: {}\n", lines_[i].line_number, answer.message);
    }
    return chunk;
  }

  const std::vector<topology::BatchLine> lines_;
  const std::function<Answer(const std::string&)>& answer_;
  std::vector<Chunk> chunks_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable ready_;
  unsigned running_ = 0;
};

}  // namespace

int run_batch(const BatchOptions& options,
              const std::function<Answer(const std::string&)>& answer) {
  Batch batch(topology::read_batch(read_file(options.file)), answer);
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  return batch.run(options.threads == 0 ? cores : options.threads, options.quiet);
}

}  // namespace tripus::cli
