#include "cli/batch.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "cli/exit_status.hpp"
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
  bool done = false;
};

class Batch {
 public:
  Batch(std::vector<topology::BatchLine> lines, unsigned threads,
        const std::function<Answer(const topology::BatchLine&)>& answer)
      : lines_(std::move(lines)),
        answer_(answer),
        chunk_size_(chunk_size(lines_.size(), threads)),
        chunks_((lines_.size() + chunk_size_ - 1) / chunk_size_),
        threads_(unsigned(std::min<std::size_t>(threads, chunks_.size()))),
        running_(threads_) {}

  /// Writes every answer in order; an interrupted run writes those that were ready.
  int run(bool quiet) {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < threads_; ++i) workers.emplace_back([this] { work(); });
    Progress progress(!quiet);
    std::size_t answered = 0;
    for (std::size_t k = 0; k < chunks_.size(); ++k) {
      const Chunk chunk = wait_for(k, progress, answered);
      answered += chunk.answered;
      write_output(chunk.text);
      flush_output();
      write_message(chunk.messages);
    }
    if (answered == lines_.size()) return kSuccess;
    write_message(
        fmt::format("tripus: interrupted: {} of {} inputs answered\n", answered, lines_.size()));
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
    const std::size_t end = std::min((k + 1) * chunk_size_, lines_.size());
    for (std::size_t i = k * chunk_size_; i < end && !interrupt_requested(); ++i) {
      const Answer answer = answer_(lines_[i]);
      ++chunk.answered;
      if (!answer.text.empty()) chunk.text += answer.text + '\n';
      if (!answer.message.empty())
        chunk.messages +=
            fmt::format("tripus: line {}: {}\n", lines_[i].line_number, answer.message);
    }
    return chunk;
  }

  const std::vector<topology::BatchLine> lines_;
  const std::function<Answer(const topology::BatchLine&)>& answer_;
  const std::size_t chunk_size_;
  std::vector<Chunk> chunks_;
  const unsigned threads_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::condition_variable ready_;
  unsigned running_;
};

}  // namespace

int run_batch(const BatchOptions& options,
              const std::function<Answer(const topology::BatchLine&)>& answer) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const unsigned threads = options.threads == 0 ? cores : options.threads;
  Batch batch(read_batch_file(options.file), threads, answer);
  catch_interrupts();
  return batch.run(options.quiet);
}

}  // namespace tripus::cli
