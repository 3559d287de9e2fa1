#pragma once

#include <cstddef>
#include <string>

#include <sys/types.h>

#include "base/stop.hpp"

namespace tripus::meshing::detail {

/// A program that runs with a socket to this one as its standard input; killed and waited for when
/// this goes out of scope, and killed by the system when this process ends in any way. Its only
/// argument is the number of this process.
class ChildProcess {
 public:
  /// Throws IoError if it cannot be started.
  explicit ChildProcess(const std::string& program);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  enum class Transfer { kDone, kClosed, kTimeOut };

  /// Both throw Stopped when `stop` is set, and give up at `deadline` (seconds of
  /// now_in_seconds).
  Transfer send(const void* data, std::size_t size, double deadline, const Stop& stop);
  Transfer receive(void* data, std::size_t size, double deadline, const Stop& stop);

  /// How it ended, once it closed the socket: "ended with status 1", "was ended by signal 11".
  /// With its last words on standard error, if it had some.
  std::string ending();
  /// The signal that ended it, 0 if none; after ending().
  int signal() const;

 private:
  bool wait_ready(short events, double deadline, const Stop& stop);
  void hear();

  pid_t process_ = -1;
  int socket_ = -1;
  int errors_ = -1;  // its standard error; -1 when it is closed
  std::string last_words_;
  int status_ = 0;
  bool ended_ = false;
};

double now_in_seconds();

}  // namespace tripus::meshing::detail
