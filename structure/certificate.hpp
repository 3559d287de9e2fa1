#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/bignum.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::structure {

using tripus::Integer;

/// Exact proof that a triangulation has no strict angle structure with given cone angles, and so no
/// metric. Source: docs/theory.md (43) and (81), where the letters u, w, a, R are defined.
struct Certificate {
  enum class Kind {
    kNone,  ///< R < 0: there is no angle structure at all
    kSemi,  ///< R = 0: in every angle structure some angle is 0 or some vertex sum is pi
  };
  Kind kind = Kind::kNone;
  std::vector<Integer> edge;                   ///< [E] u_e, of any sign
  std::vector<std::array<Integer, 4>> vertex;  ///< [T x 4] w_v, >= 0 unless the vertex is ideal
  std::vector<topology::ConeAngle> cone_angles = {};  ///< [E] rational; empty for 2 pi everywhere

  friend bool operator==(const Certificate&, const Certificate&) = default;
};

/// "none" or "semi".
std::string_view to_string(Certificate::Kind kind);

/// Exact proof that there is a strict angle structure: one, in units of pi. Angle e of tetrahedron
/// t is numerator[t][e] / denominator; 0 on parabolic edges.
struct StrictAngles {
  Integer denominator = 1;                            ///< > 0
  std::vector<std::array<Integer, 6>> numerator;      ///< [T x 6] order 01 02 03 12 13 23
  std::vector<topology::ConeAngle> cone_angles = {};  ///< [E] rational; empty for 2 pi everywhere

  friend bool operator==(const StrictAngles&, const StrictAngles&) = default;
};

/// What a check found.
struct CheckResult {
  bool valid = false;
  std::string reason;  ///< empty if valid; else the first condition that fails, with its numbers
  explicit operator bool() const { return valid; }
};

/// Checks the definition (43), (81) in exact arithmetic, and nothing else: sizes, w >= 0 but at
/// ideal vertices, a >= 0 at every corner that is not on a parabolic edge, and R < 0 (none), or R =
/// 0 with some a > 0, or w > 0 at a vertex that is not ideal (semi). O(T) operations. It shares no
/// code with what makes certificates.
CheckResult check(const topology::Triangulation& triangulation, const Certificate& certificate);

/// Checks exactly that the angles are a strict angle structure: sizes, all angles > 0 (0 on
/// parabolic edges), vertex sums < 1 (= 1 if ideal), edge sums = cone angle (units of pi).
CheckResult check(const topology::Triangulation& triangulation, const StrictAngles& angles);

/// One line of JSON: {"kind": "none", "edge": [...], "vertex": [[...], ...]}. Integers of any size.
/// With cone angles other than 2 pi also "cone_angles": ["2/3", ...], in units of pi.
std::string to_json(const Certificate& certificate);

/// One line of JSON: {"denominator": d, "numerators": [[6 integers], ...]}, angles in units of pi.
std::string to_json(const StrictAngles& angles);

/// Reads a certificate as to_json writes it, alone or as the "certificate" of a whole answer of
/// `tripus solve --json`. Integers of up to 4,932 digits. The shape is judged by `check`, not here.
/// Throws InvalidInput, naming the place and what was expected there; also for an answer without a
/// certificate.
Certificate parse_certificate(std::string_view json);

}  // namespace tripus::structure
