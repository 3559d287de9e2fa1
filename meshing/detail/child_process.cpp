#include "meshing/detail/child_process.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/stop.hpp"

extern char** environ;

namespace tripus::meshing::detail {
namespace {

/// How often a request to stop is looked at.
constexpr int kPatienceMilliseconds = 50;

/// How often, at 10 ms, it is looked whether a process that closed its socket has ended.
constexpr int kPatientTries = 50;
/// Of what it writes on standard error the end is kept.
constexpr std::size_t kLastWords = 200;

/// The child between fork and exec, where only what signal handlers may do is allowed: nothing of
/// ours but the socket, signals as at birth, and no life after its parent's. What goes wrong is
/// told through `failure`, which closes when the program starts.
[[noreturn]] void become(const char* program, char* const* arguments, int socket, int errors,
                         int failure, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  sigset_t none;
  sigemptyset(&none);
  for (const int each : {SIGINT, SIGTERM, SIGPIPE, SIGXCPU, SIGXFSZ, SIGALRM})
    ::signal(each, SIG_DFL);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (dup2(socket, STDIN_FILENO) >= 0 && dup2(nowhere, STDOUT_FILENO) >= 0 &&
      dup2(errors, STDERR_FILENO) >= 0)
    execve(program, arguments, environ);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = write(failure, &error, sizeof error);
  _exit(127);
}

/// Starts the program; the reason if that fails, else 0.
int start(pid_t& process, const std::string& program, int socket, int errors) {
  int failure[2];
  if (pipe2(failure, O_CLOEXEC) != 0) return errno;
  std::string name = program, parent = std::to_string(getpid());
  char* const arguments[] = {name.data(), parent.data(), nullptr};
  const pid_t self = getpid();
  process = fork();
  if (process == 0) become(name.c_str(), arguments, socket, errors, failure[1], self);
  int error = process < 0 ? errno : 0;
  close(failure[1]);
  if (process > 0 && read(failure[0], &error, sizeof error) > 0)
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
  close(failure[0]);
  return error;
}

}  // namespace

double now_in_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ChildProcess::ChildProcess(const std::string& program) {
  int ends[2], errors[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw IoError(std::string("no socket for the mesher: ") + std::strerror(errno));
  if (pipe2(errors, O_CLOEXEC | O_NONBLOCK) != 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw IoError(std::string("no pipe for the mesher: ") + std::strerror(error));
  }
  const int error = start(process_, program, ends[1], errors[1]);
  close(ends[1]);
  close(errors[1]);
  if (error != 0) {
    close(ends[0]);
    close(errors[0]);
    throw IoError("cannot start " + quoted(program, 200) + ": " + std::strerror(error));
  }
  socket_ = ends[0];
  errors_ = errors[0];
}

ChildProcess::~ChildProcess() {
  close(socket_);
  if (errors_ >= 0) close(errors_);
  if (ended_) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
}

bool ChildProcess::wait_ready(short events, double deadline, const Stop& stop) {
  for (;;) {
    throw_if_stopped(stop);
    if (now_in_seconds() > deadline) return false;
    pollfd wanted[2] = {{socket_, events, 0}, {errors_, POLLIN, 0}};
    if (poll(wanted, 2, kPatienceMilliseconds) <= 0) continue;
    if (wanted[1].revents != 0) hear();
    if (wanted[0].revents != 0) return true;
  }
}

/// Reads what there is of its standard error, so that it never waits for room there.
void ChildProcess::hear() {
  char block[4096];
  while (errors_ >= 0) {
    const ssize_t count = read(errors_, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return;  // nothing more yet
    if (count == 0) {
      close(errors_);
      errors_ = -1;
      return;
    }
    last_words_.append(block, static_cast<std::size_t>(count));
    if (last_words_.size() > kLastWords) last_words_.erase(0, last_words_.size() - kLastWords);
  }
}

ChildProcess::Transfer ChildProcess::send(const void* data, std::size_t size, double deadline,
                                          const Stop& stop) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    if (!wait_ready(POLLOUT, deadline, stop)) return Transfer::kTimeOut;
    const ssize_t count = ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return Transfer::kClosed;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return Transfer::kDone;
}

ChildProcess::Transfer ChildProcess::receive(void* data, std::size_t size, double deadline,
                                             const Stop& stop) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    if (!wait_ready(POLLIN, deadline, stop)) return Transfer::kTimeOut;
    const ssize_t count = ::recv(socket_, bytes, size, MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return Transfer::kClosed;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return Transfer::kDone;
}

std::string ChildProcess::ending() {
  // It closed the socket, which is as good as an end; but it may live on.
  for (int tries = 0; !ended_; ++tries) {
    if (tries == kPatientTries) kill(process_, SIGKILL);
    const pid_t waited = waitpid(process_, &status_, tries < kPatientTries ? WNOHANG : 0);
    if (waited < 0 && errno == EINTR) continue;
    ended_ = waited != 0;
    if (!ended_) poll(nullptr, 0, 10);
  }
  hear();
  while (!last_words_.empty() && last_words_.back() <= ' ') last_words_.pop_back();
  const std::string words =
      last_words_.empty() ? "" : ", its last words " + quoted(last_words_, kLastWords);
  if (WIFSIGNALED(status_))
    return "was ended by signal " + std::to_string(WTERMSIG(status_)) + words;
  return "ended with status " + std::to_string(WEXITSTATUS(status_)) + words;
}

int ChildProcess::signal() const { return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0; }

}  // namespace tripus::meshing::detail
