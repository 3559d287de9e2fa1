#include "structure/existence.hpp"

#include <limits>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/detail/existence_routes.hpp"
#include "structure/detail/small_decision.hpp"

// Of few tetrahedra a small programme in whole numbers decides that there is no strict structure.
// Else the programme of the widest margin m (docs/theory.md (50)) decides: m > 0, = 0 or < 0. Its
// primal optimum is the angle structure, its dual optimum the certificate, both with the same m.
// Three routes to exact numbers, each followed by an exact check, so that floating point only
// proposes:
//   1. round the floating-point optimum to a small common denominator;
//   2. solve the linear systems of its final basis over the rationals;
//   3. let the simplex method run over the rationals, and do 2 on its basis.

namespace tripus::structure {
namespace {

using topology::Triangulation;

/// Nothing if the time is over, which `out_of_time` then says.
std::optional<Existence> search(const Triangulation& triangulation,
                                std::span<const topology::ConeAngle> cone_angles, double seconds,
                                bool& out_of_time) {
  if (auto small = detail::decide_small(triangulation, cone_angles); small && small->certificate)
    return *std::move(small->certificate);
  detail::AngleProgramme programme(triangulation, cone_angles);
  programme.limit_time(seconds);
  std::optional<Existence> found;
  const bool solved = programme.solve();
  out_of_time = !solved && programme.is_out_of_time();
  if (out_of_time) return std::nullopt;
  if (solved) {
    found = detail::by_rounding(triangulation, programme);
    if (!found) found = detail::by_exact_basis(triangulation, programme);
  }
  if (!found && programme.solve_exactly()) found = detail::by_exact_basis(triangulation, programme);
  out_of_time = !found && programme.is_out_of_time();
  return found;
}

}  // namespace

std::optional<Existence> existence_within(double seconds, const Triangulation& triangulation,
                                          std::span<const topology::ConeAngle> cone_angles) {
  for (std::size_t e = 0; e < cone_angles.size(); ++e)
    if (!cone_angles[e].is_rational())
      throw InvalidInput("the cone angle of edge class " + std::to_string(e) +
                         " is not known to be a rational multiple of pi; angle structures are "
                         "decided exactly for such angles only");
  bool out_of_time = false;
  std::optional<Existence> found = search(triangulation, cone_angles, seconds, out_of_time);
  if (out_of_time) return std::nullopt;
  if (!found) throw InternalError("the existence of a strict angle structure could not be decided");
  if (!topology::all_full(cone_angles))
    std::visit(
        [&](auto& proof) { proof.cone_angles.assign(cone_angles.begin(), cone_angles.end()); },
        *found);
  const CheckResult result =
      std::visit([&](const auto& proof) { return check(triangulation, proof); }, *found);
  if (!result)
    throw InternalError("a proof about angle structures does not pass its check: " + result.reason);
  return found;
}

Existence existence(const Triangulation& triangulation,
                    std::span<const topology::ConeAngle> cone_angles) {
  return *existence_within(std::numeric_limits<double>::infinity(), triangulation, cone_angles);
}

}  // namespace tripus::structure
