#include "meshing/detail/child_process.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "base/stopped.hpp"

extern char** environ;

namespace tripus::meshing::detail {
namespace {

/// How often a request to stop is looked at.
constexpr int kPatienceMilliseconds = 50;

/// Spawns with nothing of ours but the socket: output goes nowhere, signals are as at birth.
int spawn(pid_t& process, const std::string& program, int socket) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&files, socket, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  sigset_t none, defaults;
  sigemptyset(&none);
  sigemptyset(&defaults);
  for (const int each : {SIGINT, SIGTERM, SIGPIPE, SIGXCPU}) sigaddset(&defaults, each);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = program, parent = std::to_string(getpid());
  char* const arguments[] = {name.data(), parent.data(), nullptr};
  const int error = posix_spawn(&process, program.c_str(), &files, &attributes, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  return error;
}

}  // namespace

double now_in_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ChildProcess::ChildProcess(const std::string& program) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Unsupported(std::string("no socket for the mesher: ") + std::strerror(errno));
  const int error = spawn(process_, program, ends[1]);
  close(ends[1]);
  if (error != 0) {
    close(ends[0]);
    throw Unsupported("cannot start " + quoted(program, 200) + ": " + std::strerror(error));
  }
  socket_ = ends[0];
}

ChildProcess::~ChildProcess() {
  close(socket_);
  if (ended_) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
}

bool ChildProcess::wait_ready(short events, double deadline,
                              const std::atomic<bool>* stop_requested) {
  for (;;) {
    throw_if_stopped(stop_requested);
    if (now_in_seconds() > deadline) return false;
    pollfd wanted{socket_, events, 0};
    if (poll(&wanted, 1, kPatienceMilliseconds) > 0) return true;
  }
}

ChildProcess::Transfer ChildProcess::send(const void* data, std::size_t size, double deadline,
                                          const std::atomic<bool>* stop_requested) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    if (!wait_ready(POLLOUT, deadline, stop_requested)) return Transfer::kTimeOut;
    const ssize_t count = ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return Transfer::kClosed;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return Transfer::kDone;
}

ChildProcess::Transfer ChildProcess::receive(void* data, std::size_t size, double deadline,
                                             const std::atomic<bool>* stop_requested) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    if (!wait_ready(POLLIN, deadline, stop_requested)) return Transfer::kTimeOut;
    const ssize_t count = ::recv(socket_, bytes, size, MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return Transfer::kClosed;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return Transfer::kDone;
}

std::string ChildProcess::ending() {
  while (!ended_) {
    const pid_t waited = waitpid(process_, &status_, 0);
    if (waited < 0 && errno == EINTR) continue;
    ended_ = true;
  }
  if (WIFSIGNALED(status_)) return "was ended by signal " + std::to_string(WTERMSIG(status_));
  return "ended with status " + std::to_string(WEXITSTATUS(status_));
}

int ChildProcess::signal() const { return WIFSIGNALED(status_) ? WTERMSIG(status_) : 0; }

}  // namespace tripus::meshing::detail
