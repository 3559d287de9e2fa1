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
  std::string digits = to_decimal(value);
  if (digits.size() > 40)
    digits = fmt::format("{}...{} ({} digits)", digits.substr(0, 12),
                         digits.substr(digits.size() - 6), digits.size());
  return digits;
}

std::string corner_name(const Triangulation& triangulation, std::size_t t, std::size_t e) {
  return fmt::format("edge {}{} of tetrahedron {} (edge class {})", kEdgeEnds[e][0],
                     kEdgeEnds[e][1], t, triangulation.edge_class(t, static_cast<int>(e)));
}

/// What the labels say, computed from the definitions (76) and (81).
struct Labels {
  std::vector<BigRational> edge_sum;  ///< [E] units of pi
  std::vector<bool> ideal;            ///< [V]
  bool is_parabolic(std::size_t e) const { return edge_sum[e] == 0; }
};

/// Why these are not cone angles of the triangulation, or empty.
std::string read_labels(const Triangulation& triangulation,
                        const std::vector<topology::ConeAngle>& cone_angles, Labels& labels) {
  const std::size_t edges = triangulation.edge_count();
  labels.edge_sum.assign(edges, 2);
  if (cone_angles.empty()) {
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
      labels.ideal.push_back(triangulation.link(v).euler_characteristic == 0);
    return {};
  }
  if (cone_angles.size() != edges)
    return fmt::format("there are {} cone angles, the triangulation has {} edge classes",
                       cone_angles.size(), edges);
  for (std::size_t e = 0; e < edges; ++e) {
    if (!cone_angles[e].is_rational())
      return fmt::format("the cone angle of edge class {} is not a fraction of pi", e);
    labels.edge_sum[e] = BigRational(cone_angles[e].numerator(), cone_angles[e].denominator());
  }
  // Twice the Euler characteristic: 2 chi(link) - sum over edge ends of (2 - k_e).
  std::vector<BigRational> twice(triangulation.vertex_count());
  for (std::size_t v = 0; v < twice.size(); ++v)
    twice[v] = 2 * triangulation.link(v).euler_characteristic;
  for (std::size_t e = 0; e < edges; ++e) {
    const auto corner = triangulation.corners(e)[0];
    for (const int end : kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      twice[triangulation.vertex_class(corner.tetrahedron(), end)] += labels.edge_sum[e] - 2;
  }
  for (const BigRational& each : twice) labels.ideal.push_back(each == 0);
  return {};
}

bool is_ideal(const Triangulation& triangulation, const Labels& labels, std::size_t t,
              std::size_t v) {
  return labels.ideal[triangulation.vertex_class(t, static_cast<int>(v))];
}

std::string shown(const BigRational& value) {
  return denominator_of(value) == 1
             ? shown(numerator_of(value))
             : shown(numerator_of(value)) + "/" + shown(denominator_of(value));
}

/// The first negative vertex multiplier that must not be negative.
std::optional<std::string> negative_multiplier(const Triangulation& triangulation,
                                               const Labels& labels,
                                               const Certificate& certificate) {
  for (std::size_t t = 0; t < certificate.vertex.size(); ++t)
    for (std::size_t v = 0; v < 4; ++v)
      if (const Integer& w = certificate.vertex[t][v];
          w < 0 && !is_ideal(triangulation, labels, t, v))
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
  Labels labels;
  if (auto reason = read_labels(triangulation, certificate.cone_angles, labels); !reason.empty())
    return fails(std::move(reason));
  if (auto reason = negative_multiplier(triangulation, labels, certificate))
    return fails(std::move(*reason));

  bool something_positive = false;
  BigRational r = 0;
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    for (std::size_t v = 0; v < 4; ++v) {
      const Integer& w = certificate.vertex[t][v];
      r += w;
      if (w > 0 && !is_ideal(triangulation, labels, t, v)) something_positive = true;
    }
    for (std::size_t e = 0; e < 6; ++e) {
      if (labels.is_parabolic(triangulation.edge_class(t, static_cast<int>(e)))) continue;
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
  for (std::size_t e = 0; e < certificate.edge.size(); ++e)
    r -= labels.edge_sum[e] * certificate.edge[e];

  const char* edges_times = certificate.cone_angles.empty()
                                ? "2 times that of the edge multipliers"
                                : "that of the edge multipliers times cone angle / pi";
  if (certificate.kind == Certificate::Kind::kNone && r >= 0) {
    return fails(
        fmt::format("the sum of the vertex multipliers - {} is {}; kind \"none\" needs less than 0",
                    edges_times, shown(r)));
  }
  if (certificate.kind == Certificate::Kind::kSemi && r != 0) {
    return fails(fmt::format("the sum of the vertex multipliers - {} is {}; kind \"semi\" needs 0",
                             edges_times, shown(r)));
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
  Labels labels;
  if (auto reason = read_labels(triangulation, angles.cone_angles, labels); !reason.empty())
    return fails(std::move(reason));

  std::vector<Integer> edge_sum(triangulation.edge_count());
  for (std::size_t t = 0; t < tetrahedra; ++t) {
    std::array<Integer, 4> vertex_sum;
    for (std::size_t e = 0; e < 6; ++e) {
      const Integer& angle = angles.numerator[t][e];
      const bool parabolic = labels.is_parabolic(triangulation.edge_class(t, static_cast<int>(e)));
      if (parabolic && angle != 0) {
        return fails(fmt::format("the angle at {} is {}/{} pi, but the edge is parabolic",
                                 corner_name(triangulation, t, e), shown(angle),
                                 shown(angles.denominator)));
      }
      if (!parabolic && angle <= 0) {
        return fails(fmt::format("the angle at {} is {}/{} pi, not positive",
                                 corner_name(triangulation, t, e), shown(angle),
                                 shown(angles.denominator)));
      }
      for (const int end : kEdgeEnds[e]) vertex_sum[static_cast<std::size_t>(end)] += angle;
      edge_sum[triangulation.edge_class(t, static_cast<int>(e))] += angle;
    }
    for (std::size_t v = 0; v < 4; ++v) {
      if (is_ideal(triangulation, labels, t, v)) {
        if (vertex_sum[v] == angles.denominator) continue;
        return fails(fmt::format(
            "the angles at the ideal vertex {} of tetrahedron {} add up to {}/{} pi, not to pi", v,
            t, shown(vertex_sum[v]), shown(angles.denominator)));
      }
      if (vertex_sum[v] >= angles.denominator) {
        return fails(fmt::format(
            "the angles at vertex {} of tetrahedron {} add up to {}/{} pi, not less than pi", v, t,
            shown(vertex_sum[v]), shown(angles.denominator)));
      }
    }
  }
  for (std::size_t e = 0; e < edge_sum.size(); ++e) {
    if (edge_sum[e] != labels.edge_sum[e] * angles.denominator) {
      return fails(fmt::format("the angles around edge class {} add up to {}/{} pi, not to {} pi",
                               e, shown(edge_sum[e]), shown(angles.denominator),
                               shown(labels.edge_sum[e])));
    }
  }
  return {true, {}};
}

}  // namespace tripus::structure
