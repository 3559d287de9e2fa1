#pragma once

#include <system_error>
#include <thread>
#include <vector>

namespace tripus {

/// The cores of the machine where `wanted` is 0.
inline unsigned thread_count(unsigned wanted) {
  const unsigned cores = std::thread::hardware_concurrency();
  return wanted != 0 ? wanted : cores != 0 ? cores : 1;
}

/// Starts `work` on so many threads, or on as many as the system still gives: fewer do the same
/// work later. They are joined where the result goes out of scope. `work` must not throw.
template <class Work>
std::vector<std::jthread> start_threads(std::size_t count, const Work& work) {
  std::vector<std::jthread> threads;
  threads.reserve(count);
  try {
    while (threads.size() < count) threads.emplace_back([&work] { work(); });
  } catch (const std::system_error&) {  // no memory for a stack, or a limit on processes
  }
  return threads;
}

/// The same, and on this thread too; returns when all are done.
template <class Work>
void run_on_threads(std::size_t count, const Work& work) {
  const auto others = start_threads(count > 0 ? count - 1 : 0, work);
  work();
}

}  // namespace tripus
