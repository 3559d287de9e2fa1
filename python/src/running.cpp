#include "python/src/running.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>

#include <fmt/format.h>
#include <pthread.h>

#include "base/stop.hpp"

namespace tripus::python {
namespace {

/// The flag of the work that the main thread is at: what the signal handler may touch.
std::atomic<std::atomic<bool>*> current_flag{nullptr};
/// Python's own handler, which is called after ours.
void (*python_handler)(int) = nullptr;

pthread_t main_thread;
bool has_main_thread = false;
bool is_forked = false;

void on_interrupt(int signal) {
  if (std::atomic<bool>* flag = current_flag.load(std::memory_order_relaxed))
    flag->store(true, std::memory_order_relaxed);
  if (python_handler != nullptr) python_handler(signal);
}

void after_fork_in_child() {
  is_forked = true;
  main_thread = pthread_self();  // as Python has it
  has_main_thread = true;
}

bool in_main_thread() { return has_main_thread && pthread_equal(main_thread, pthread_self()) != 0; }

}  // namespace

void prepare_for_work() {
  const nb::object threading = nb::module_::import_("threading");
  const nb::object main = threading.attr("main_thread")().attr("ident");
  main_thread = reinterpret_cast<pthread_t>(nb::cast<std::uintptr_t>(main));
  has_main_thread = true;
  pthread_atfork(nullptr, nullptr, after_fork_in_child);
}

Work::Work(const Limits& limits) : time_limit_(limits.time_limit), progress_(limits.progress) {
  context_.threads = limits.threads;
  context_.stop = &stop_;
  if (limits.time_limit) {
    context_.deadline = Context::Clock::now() +
                        std::chrono::duration_cast<Context::Clock::duration>(
                            std::chrono::duration<double>(std::min(*limits.time_limit, 1e9)));
    start_timer();
  }
  if (progress_.is_valid() && !progress_.is_none())
    context_.progress = [this](std::string_view activity, std::size_t tetrahedra) {
      report(activity, tetrahedra);
    };
  context_.note = [this](const std::string& note) {
    const std::lock_guard lock(mutex_);
    notes_.push_back(note);
  };
  if (!in_main_thread()) return;
  struct sigaction now {};
  if (sigaction(SIGINT, nullptr, &now) != 0) return;
  // Where Python does not handle Ctrl-C, neither do we; where we already do, this work is within
  // a callback of other work.
  const bool ours = (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler == on_interrupt;
  if ((now.sa_flags & SA_SIGINFO) != 0 || now.sa_handler == SIG_DFL || now.sa_handler == SIG_IGN)
    return;
  outer_ = current_flag.exchange(&stop_);
  catches_ = true;
  previous_ = now;
  if (ours) return;
  python_handler = now.sa_handler;
  struct sigaction mine = now;
  mine.sa_handler = on_interrupt;
  sigaction(SIGINT, &mine, nullptr);
}

void Work::start_timer() {
  timer_ = std::jthread([this](const std::stop_token& over) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    const auto end = *context_.deadline + std::chrono::milliseconds(20);
    if (wake.wait_until(lock, over, end, [] { return false; }) || over.stop_requested()) return;
    timed_out_ = true;
    stop_ = true;
  });
}

Work::~Work() {
  if (!catches_) return;
  current_flag = outer_;
  if (outer_ == nullptr) sigaction(SIGINT, &previous_, nullptr);
}

void Work::report(std::string_view activity, std::size_t tetrahedra) {
  if (stop_) return;
  const nb::gil_scoped_acquire locked;
  try {
    progress_(nb::str(activity.data(), activity.size()), tetrahedra);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    stop_ = true;
  }
}

void Work::call(const std::function<void()>& work) {
  stop_ = timed_out_.load();
  const nb::gil_scoped_release unlocked;
  if (is_forked) {
    std::thread(work).join();
  } else {
    work();
  }
}

bool Work::must_repeat() {
  if (!stop_) return false;
  if (failure_) std::rethrow_exception(failure_);
  if (PyErr_CheckSignals() != 0) throw nb::python_error();
  return !timed_out_;
}

void Work::rethrow(const std::exception_ptr& error) const {
  if (time_limit_ && context_.expired()) {
    try {
      std::rethrow_exception(error);
    } catch (const Stopped&) {
      const nb::object type = nb::module_::import_("tripus._errors").attr("Stopped");
      const std::string text = fmt::format(
          "the time limit of {:.6g} s was over before there was anything to return", *time_limit_);
      PyErr_SetString(type.ptr(), text.c_str());
      throw nb::python_error();
    }
  }
  std::rethrow_exception(error);
}

void Work::warn() const {
  if (notes_.empty()) return;
  const nb::object category = nb::module_::import_("tripus._errors").attr("InputNote");
  for (const std::string& note : notes_)
    if (PyErr_WarnEx(category.ptr(), note.c_str(), 3) != 0) throw nb::python_error();
}

}  // namespace tripus::python
