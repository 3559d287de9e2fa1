#include "structure/certificate.hpp"

#include <string>

namespace tripus::structure {
namespace {

/// Appends [a, b, ...], integers.
template <class Integers>
void append_integers(std::string& out, const Integers& integers) {
  out += '[';
  for (std::size_t i = 0; i < integers.size(); ++i) {
    if (i > 0) out += ", ";
    out += to_decimal(integers[i]);
  }
  out += ']';
}

/// Appends [[...], ...].
template <class Rows>
void append_rows(std::string& out, const Rows& rows) {
  out += '[';
  for (std::size_t t = 0; t < rows.size(); ++t) {
    if (t > 0) out += ", ";
    append_integers(out, rows[t]);
  }
  out += ']';
}

/// In units of pi; nothing if they are all 2.
void append_cone_angles(std::string& out, const std::vector<topology::ConeAngle>& cone_angles) {
  if (cone_angles.empty()) return;
  out += ", \"cone_angles\": [";
  for (std::size_t e = 0; e < cone_angles.size(); ++e) {
    if (e > 0) out += ", ";
    out += '"' + std::to_string(cone_angles[e].numerator());
    if (cone_angles[e].denominator() != 1)
      out += '/' + std::to_string(cone_angles[e].denominator());
    out += '"';
  }
  out += ']';
}

}  // namespace

std::string_view to_string(Certificate::Kind kind) {
  return kind == Certificate::Kind::kNone ? "none" : "semi";
}

std::string to_json(const Certificate& certificate) {
  std::string out = R"({"kind": ")";
  out += to_string(certificate.kind);
  out += R"(", "edge": )";
  append_integers(out, certificate.edge);
  out += ", \"vertex\": ";
  append_rows(out, certificate.vertex);
  append_cone_angles(out, certificate.cone_angles);
  return out + "}";
}

std::string to_json(const StrictAngles& angles) {
  std::string out = "{\"denominator\": " + to_decimal(angles.denominator) + ", \"numerators\": ";
  append_rows(out, angles.numerator);
  append_cone_angles(out, angles.cone_angles);
  return out + "}";
}

}  // namespace tripus::structure
