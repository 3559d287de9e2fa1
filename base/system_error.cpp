#include "base/system_error.hpp"

#include <cerrno>
#include <cstring>

namespace tripus {
namespace {

bool is_about_the_name(int error) {
  switch (error) {
    case ENOENT:
    case EACCES:
    case EPERM:
    case ENOTDIR:
    case EISDIR:
    case ENAMETOOLONG:
    case ELOOP:
    case EROFS:
    case EEXIST:
    case EINVAL:
    case ENXIO:
    case ENODEV:
    case ETXTBSY:
      return true;
    default:
      return false;
  }
}

}  // namespace

void fail_on_file(const std::string& what, const std::string& path, int error) {
  const std::string text = what + " " + quoted(path) + ": " + std::strerror(error);
  if (is_about_the_name(error)) throw UnusableFile(text);
  throw IoError(text);
}

}  // namespace tripus
