#include "cli/failure.hpp"

#include <new>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stopped.hpp"
#include "cli/exit_status.hpp"
#include "topology/work_size.hpp"

namespace tripus::cli {
namespace {

/// What a tetrahedron takes at the height of `tripus solve`, all told: measured, see
/// docs/reliability.md. Other verbs take less, or not much more.
constexpr double kBytesPerTetrahedron = 3000;

bool is_out_of_memory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  if (dynamic_cast<const std::length_error*>(&error) != nullptr) return true;  // of a container
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && (system->code() == std::errc::resource_unavailable_try_again ||
                               system->code() == std::errc::not_enough_memory);
}

std::string bytes_text(double bytes) {
  for (const auto& [unit, size] : {std::pair{"GB", 1e9}, std::pair{"MB", 1e6}})
    if (bytes >= 10 * size || (bytes >= size && *unit == 'G'))
      return fmt::format("{:.0f} {}", bytes / size, unit);
  return "10 MB";
}

}  // namespace

std::string failure_text(const std::exception& error) {
  if (!is_out_of_memory(error)) return error.what();
  const std::size_t tetrahedra = topology::work_size();
  if (tetrahedra == 0) return "not enough memory, even to begin";
  return fmt::format("not enough memory for {} tetrahedra (needs about {})", tetrahedra,
                     bytes_text(double(tetrahedra) * kBytesPerTetrahedron + 20e6));
}

int status_of(const std::exception& error) {
  if (dynamic_cast<const Stopped*>(&error) != nullptr) return kNoAnswer;
  return dynamic_cast<const InvalidInput*>(&error) != nullptr ? kBadInput : kInternalFailure;
}

}  // namespace tripus::cli
