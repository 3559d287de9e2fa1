#include "cli/failure.hpp"

#include <new>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "cli/interrupt.hpp"
#include "manifold/json_text.hpp"
#include "topology/work_size.hpp"

namespace tripus::cli {
namespace {

/// What the program takes before it begins, and a tetrahedron at the height of `tripus solve` of a
/// gluing table: measured, see docs/reliability.md. Other verbs take as much or a few times more.
constexpr double kBytesAtLeast = 110e6, kBytesPerTetrahedron = 800;

bool is_out_of_memory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  if (dynamic_cast<const std::length_error*>(&error) != nullptr) return true;  // of a container
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  return system != nullptr && (system->code() == std::errc::resource_unavailable_try_again ||
                               system->code() == std::errc::not_enough_memory);
}

bool is_stop(const std::exception& error) {
  return dynamic_cast<const Stopped*>(&error) != nullptr;
}

std::string bytes_text(double bytes) {
  return bytes >= 1e9 ? fmt::format("{:.1f} GB", bytes / 1e9)
                      : fmt::format("{:.0f} MB", bytes / 1e6);
}

}  // namespace

std::string failure_text(const std::exception& error) {
  if (is_stop(error)) return stop_text();
  if (!is_out_of_memory(error)) return error.what();
  const std::size_t tetrahedra = topology::work_size();
  if (tetrahedra == 0) return "not enough memory, even to begin";
  return fmt::format("not enough memory for {} tetrahedra (needs about {})", tetrahedra,
                     bytes_text(double(tetrahedra) * kBytesPerTetrahedron + kBytesAtLeast));
}

std::string_view failure_kind(const std::exception& error) {
  return is_stop(error) && is_time_over() ? "time-limit" : error_kind(error);
}

int status_of(const std::exception& error) {
  if (is_stop(error)) return kNoAnswer;
  return dynamic_cast<const InvalidInput*>(&error) != nullptr ? kBadInput : kInternalFailure;
}

}  // namespace tripus::cli
