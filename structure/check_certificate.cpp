// The checks of certificate.hpp, written from the definitions alone. Nothing here is shared with
// the code that makes certificates, so that a fault there cannot hide itself.
#include <optional>

#include <fmt/format.h>

#include "structure/certificate.hpp"

namespace tripus::structure {
namespace {

using topology::kEdgeEnds;
using topology::Triangulation;

CheckResult fails(std::string reason) { return {false, std::move(reason)}; }

/// What follows in the message of a sum: its number, shortened where nobody would read it.
std::string shown(const Integer& value) {
  std::string digits = value.get_str();
  if (digits.size() > 40)
    digits = fmt::format("{}...{} ({} digits)", digits.substr(0, 12),
                         digits.substr(digits.size() - 6), digits.size());
  return digits;
}

std::string corner_name(const Triangulation& triangulation, std::size_t t, std::size_t e) {
  return fmt::format("edge {}{} of tetrahedron {} (edge class {})", kEdgeEnds[e][0],
                     kEdgeEnds[e][1], t, triangulation.edge_class(t, static_cast<int>(e)));
}

/// The first negative vertex multiplier.
std::optional<std::string> negative_multiplier(const Certificate& certificate) {
  for (std::size_t t = 0; t < certificate.vertex.size(); ++t)
    for (std::size_t v = 0; v < 4; ++v)
      if (const Integer& w = certificate.vertex[t][v]; w < 0)
        return fmt::format("the multiplier of vertex {} of tetrahedron {} is {}, below 0", v, t,
                           shown(w));
  return std::nullopt;
}

}  // namespace

CheckResult check(const Triangulation& triangulation, const Certificate& certificate) {
  const std::size_t tetrahedra = triangulation.tetrahedron_count();
  if (certificate.edge.size() != triangulation.edge_count()) {
    return fails(
        fmt::format("the certificate has {} edge multipliers, the triangulation {} edge "
                    "classes",
                    certificate.edge.size(), triangulation.edge_count()));
  }
  if (certificate.vertex.size() != tetrahedra) {
    return fails(
        fmt::format("the certificate has vertex multipliers for {} tetrahedra, the "
                    "triangulation has {}",
                    certificate.vertex.size(), tetrahedra));
  }
  if (auto reason = negative_multiplier(certificate)) return fails(std::move(*reason));

  bool something_positive = false;
  Integer r = 0;
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    for (const Integer& w : certificate.vertex[t]) {
      r += w;
      if (w > 0) something_positive = true;
    }
    for (std::size_t e = 0; e < 6; ++e) {
      const Integer& w0 = certificate.vertex[t][static_cast<std::size_t>(kEdgeEnds[e][0])];
      const Integer& w1 = certificate.vertex[t][static_cast<std::size_t>(kEdgeEnds[e][1])];
      const Integer& u = certificate.edge[triangulation.edge_class(t, static_cast<int>(e))];
      const Integer a = w0 + w1 - u;
      if (a < 0) {
        return fails(fmt::format("at {}, vertex + vertex - edge = {} + {} - ({}) = {}, below 0",
                                 corner_name(triangulation, t, e), shown(w0), shown(w1), shown(u),
                                 shown(a)));
      }
      if (a > 0) something_positive = true;
    }
  }
  for (const Integer& u : certificate.edge) r -= 2 * u;

  if (certificate.kind == Certificate::Kind::kNone && r >= 0) {
    return fails(fmt::format(
        "the sum of the vertex multipliers - 2 times that of the edge multipliers is {}; kind "
        "\"none\" needs less than 0",
        shown(r)));
  }
  if (certificate.kind == Certificate::Kind::kSemi && r != 0) {
    return fails(fmt::format(
        "the sum of the vertex multipliers - 2 times that of the edge multipliers is {}; kind "
        "\"semi\" needs 0",
        shown(r)));
  }
  if (certificate.kind == Certificate::Kind::kSemi && !something_positive)
    return fails("all multipliers are 0, which excludes nothing");
  return {true, {}};
}

CheckResult check(const Triangulation& triangulation, const StrictAngles& angles) {
  const std::size_t tetrahedra = triangulation.tetrahedron_count();
  if (angles.numerator.size() != tetrahedra) {
    return fails(fmt::format("there are angles for {} tetrahedra, the triangulation has {}",
                             angles.numerator.size(), tetrahedra));
  }
  if (angles.denominator <= 0)
    return fails(fmt::format("the denominator is {}, not positive", shown(angles.denominator)));

  std::vector<Integer> edge_sum(triangulation.edge_count());
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    std::array<Integer, 4> vertex_sum;
    for (std::size_t e = 0; e < 6; ++e) {
      const Integer& angle = angles.numerator[t][e];
      if (angle <= 0) {
        return fails(fmt::format("the angle at {} is {}/{} pi, not positive",
                                 corner_name(triangulation, t, e), shown(angle),
                                 shown(angles.denominator)));
      }
      for (const int end : kEdgeEnds[e]) vertex_sum[static_cast<std::size_t>(end)] += angle;
      edge_sum[triangulation.edge_class(t, static_cast<int>(e))] += angle;
    }
    for (std::size_t v = 0; v < 4; ++v) {
      if (vertex_sum[v] >= angles.denominator) {
        return fails(fmt::format(
            "the angles at vertex {} of tetrahedron {} add up to {}/{} pi, not less than pi", v, t,
            shown(vertex_sum[v]), shown(angles.denominator)));
      }
    }
  }
  for (std::size_t e = 0; e < edge_sum.size(); ++e) {
    if (edge_sum[e] != 2 * angles.denominator) {
      return fails(fmt::format("the angles around edge class {} add up to {}/{} pi, not to 2 pi", e,
                               shown(edge_sum[e]), shown(angles.denominator)));
    }
  }
  return {true, {}};
}

}  // namespace tripus::structure
