#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <optional>

#include "base/threads.hpp"

namespace tripus {

/// Calls `make(k)` for k = 0 ... count - 1 on so many threads and `use(k, result)` on this one, in
/// their order, so that the result does not depend on the threads. `make` returns a std::optional:
/// without a value the work ends before k, and so does it where `use` returns false. At most some
/// results for each thread wait for their turn. Throws what `make` and `use` throw, the first of
/// them. Returns how many were used.
template <class Make, class Use>
std::size_t in_order(std::size_t count, std::size_t threads, const Make& make, const Use& use) {
  using Result = decltype(make(std::size_t{}));
  constexpr std::size_t kAhead = 8;
  std::mutex mutex;
  std::condition_variable changed;
  std::map<std::size_t, Result> waiting;
  std::size_t next = 0, used = 0;
  bool ended = false;
  std::exception_ptr failure;
  const auto work = [&] {
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, [&] { return ended || next == count || next < used + kAhead * threads; });
      if (ended || next == count) return;
      const std::size_t k = next++;
      lock.unlock();
      Result result;
      std::exception_ptr thrown;
      try {
        result = make(k);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      if (thrown && !failure) failure = thrown;
      if (thrown) ended = true;
      waiting.emplace(k, std::move(result));
      changed.notify_all();
    }
  };
  const auto end = [&] {
    const std::lock_guard lock(mutex);
    ended = true;
    changed.notify_all();
  };
  const auto workers = start_threads(threads < count ? threads : count, work);
  struct AtExit {
    const decltype(end)& call;
    ~AtExit() { call(); }
  } at_exit{end};  // before the threads are joined, whatever happens
  while (used < count) {
    Result result;
    if (workers.empty()) {
      result = make(used);
    } else {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return failure || waiting.contains(used); });
      if (failure) break;
      result = std::move(waiting.extract(used).mapped());
    }
    if (!result || !use(used, *result)) break;
    const std::lock_guard lock(mutex);
    ++used;
    changed.notify_all();
  }
  end();
  if (failure) std::rethrow_exception(failure);
  return used;
}

}  // namespace tripus
