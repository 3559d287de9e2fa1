#pragma once

#include <string>

#include "base/error.hpp"

namespace tripus {

/// A file that was named cannot be used: it is not there, it is a folder, nobody may read or write
/// it. Another name helps.
class UnusableFile : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// Throws what a failed call of the system on a file deserves: UnusableFile if another name helps
/// (there is no such folder, nobody may write there), IoError if the machine fails (a full disk, a
/// broken one, no file descriptors). `what`: "cannot write", say.
[[noreturn]] void fail_on_file(const std::string& what, const std::string& path, int error);

}  // namespace tripus
