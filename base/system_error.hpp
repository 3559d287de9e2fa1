#pragma once

#include <string>

namespace tripus {

/// Throws what a failed call of the system on a file deserves: InvalidInput if another name helps
/// (there is no such folder, nobody may write there), IoError if the machine fails (a full disk, a
/// broken one, no file descriptors). `what`: "cannot write", say.
[[noreturn]] void fail_on_file(const std::string& what, const std::string& path, int error);

}  // namespace tripus
