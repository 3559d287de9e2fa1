#include "structure/certificate.hpp"

namespace tripus::structure {
namespace {

/// Appends [a, b, ...].
template <class Integers>
void append_integers(std::string& out, const Integers& integers) {
  out += '[';
  for (std::size_t i = 0; i < integers.size(); ++i) {
    if (i > 0) out += ", ";
    out += integers[i].get_str();
  }
  out += ']';
}

}  // namespace

std::string_view to_string(Certificate::Kind kind) {
  return kind == Certificate::Kind::kNone ? "none" : "semi";
}

std::string to_json(const Certificate& certificate) {
  std::string out = "{\"kind\": \"";
  out += to_string(certificate.kind);
  out += "\", \"edge\": ";
  append_integers(out, certificate.edge);
  out += ", \"vertex\": [";
  for (std::size_t t = 0; t < certificate.vertex.size(); ++t) {
    if (t > 0) out += ", ";
    append_integers(out, certificate.vertex[t]);
  }
  out += "]}";
  return out;
}

}  // namespace tripus::structure
