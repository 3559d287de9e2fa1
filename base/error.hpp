#pragma once

#include <stdexcept>
#include <string>

namespace tripus {

/// Root of everything that the library throws.
///
/// Four kinds of failure are kept apart: our own bug is an assertion (or an InternalError where it
/// can be detected cheaply), the caller's input is an InvalidInput, a failure of the system (file,
/// disk, process) an IoError, and a mathematical outcome ("no metric") is returned, never thrown.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller's input cannot be used. The message names the place (tetrahedron, face, line,
/// option), the offending value and what to do about it.
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// The input is well formed but outside what Tripus supports so far (cusps, for example).
class Unsupported : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// The system failed: a full disk, a file that cannot be opened or written, a helper program that
/// ends badly. The message names the file and the system's reason.
class IoError : public Error {
 public:
  using Error::Error;
};

/// A promise of ours was broken: please report it.
class InternalError : public Error {
 public:
  using Error::Error;
};

/// Text of unknown origin made fit for a one-line message: control and non-ASCII bytes are
/// escaped as \xHH, and what is longer than `limit` characters is cut with "...".
std::string quoted(const std::string& text, std::size_t limit = 60);

}  // namespace tripus
