#include "structure/proof/proof_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/detail/guarded_json.hpp"
#include "base/error.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/proof_json.hpp"

namespace tripus::structure {
namespace {

using detail::interval_json;
using detail::list_json;
using detail::member;
using detail::read_interval;
using detail::read_texts;
using detail::refuse;
using nlohmann::json;

constexpr std::string_view kStrongConvexity = "strong-convexity";
constexpr std::string_view kIntervalNewton = "interval-newton";
constexpr std::string_view kTexts = "an array of texts, one number an edge class";

/// A decimal number that is larger by at least half a percent: radii need no more digits.
std::string rounded_up(double value) {
  return value > 0 ? fmt::format("{:.2e}", value * 1.01) : "0";
}

/// Two units in the last place outwards, where 17 digits are off by less than one.
std::string outwards(double value, double direction) {
  return fmt::format("{:.17g}", std::nextafter(std::nextafter(value, direction), direction));
}

/// In units of pi, "2/3"; or in radians, exactly, "0x1.8p+0", where it is no such fraction.
std::string cone_angle_json(const topology::ConeAngle& angle) {
  if (!angle.is_rational()) return fmt::format("\"{:a}\"", angle.radians());
  if (angle.denominator() == 1) return fmt::format("\"{}\"", angle.numerator());
  return fmt::format("\"{}/{}\"", angle.numerator(), angle.denominator());
}

topology::ConeAngle read_cone_angle(const std::string& text, std::size_t edge) {
  using topology::ConeAngle;
  const char *at = text.data(), *end = text.data() + text.size();
  const auto refuse_it = [&]() {
    refuse(fmt::format("the cone angle {} of edge class {}", quoted(text), edge),
           "a fraction of pi such as \"2/3\", or radians such as \"0x1.8p+0\"");
  };
  if (text.starts_with("0x")) {
    double radians = 0;
    const auto [stop, code] = std::from_chars(at + 2, end, radians, std::chars_format::hex);
    if (code != std::errc() || stop != end || !(radians >= 0) || !std::isfinite(radians))
      refuse_it();
    return ConeAngle(radians);
  }
  std::int64_t terms[2] = {0, 1};
  auto [stop, code] = std::from_chars(at, end, terms[0]);
  if (code == std::errc() && stop != end && *stop == '/') {
    const auto rest = std::from_chars(stop + 1, end, terms[1]);
    stop = rest.ptr;
    code = rest.ec;
  }
  if (code != std::errc() || stop != end || terms[0] < 0 || terms[1] < 1 ||
      std::max(terms[0], terms[1]) > ConeAngle::kLargestTerm)
    refuse_it();
  return ConeAngle::rational(terms[0], terms[1]);
}

/// What is not checked, as it only says how the proof was made.
std::size_t read_count(const json& object, const char* name, std::size_t without) {
  const auto found = object.find(name);
  if (found == object.end()) return without;
  if (!found->is_number_unsigned() || *found > 1000000000000u)
    refuse(fmt::format("\"{}\"", name), "a whole number");
  return found->get<std::size_t>();
}

json parse_object(std::string_view text) {
  constexpr std::string_view kExpected =
      "an object with a \"proof\", such as an answer of `tripus prove --json`";
  json document = tripus::detail::parse_guarded_json(text, kExpected);
  if (!document.is_object()) throw InvalidInput(fmt::format("JSON: expected {}", kExpected));
  return document;
}

const json& proof_member(const json& document) {
  const auto found = document.find("proof");
  return found == document.end() ? document : *found;
}

}  // namespace

std::string_view kind_of(const ProofText& proof) {
  return proof.interval_newton ? kIntervalNewton : kStrongConvexity;
}

ProofText proof_text(const Proof& proof, const Digits* digits) {
  ProofText text;
  text.proved = proof.proved && (digits == nullptr || digits->proved);
  text.reason = proof.proved && digits != nullptr ? digits->reason : proof.reason;
  text.claim = proof.claim;
  text.interval_newton = proof.claim == Proof::Claim::kMetric && !proof.weights.empty() &&
                         std::ranges::all_of(proof.weights, [](double d) { return d == 0; }) &&
                         proof.largest_radius() > 0;
  text.bits = proof.bits;
  text.escalated = proof.escalated;
  text.flat = proof.flat;
  text.cone_angles = proof.cone_angles;
  if (digits != nullptr && digits->proved) {
    text.bits = std::max(text.bits, digits->bits);
    text.lengths = digits->lengths;
    text.radii = digits->radii;
    text.volume = digits->volume;
    text.dihedral_angles = digits->dihedral_angles;
    return text;
  }
  if (!text.proved) return text;
  for (const double l : proof.lengths) text.lengths.push_back(fmt::format("{:a}", l));
  for (const double r : proof.radii) text.radii.push_back(rounded_up(r));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (proof.volume.upper > 0)
    text.volume = {outwards(proof.volume.lower, -kInfinity),
                   outwards(proof.volume.upper, kInfinity)};
  return text;
}

std::string to_json(const ProofText& proof) {
  const auto quoted_text = [](const std::string& text) { return '"' + text + '"'; };
  std::string text =
      fmt::format("{{\"kind\": \"{}\", \"proved\": {}", kind_of(proof), proof.proved);
  if (!proof.proved) return text + ", \"reason\": " + json(proof.reason).dump() + "}";
  text += fmt::format(
      ", \"claim\": \"{}\", \"bits\": {}, \"escalated\": {}, \"lengths\": {}, "
      "\"radii\": {}",
      proof.claim == Proof::Claim::kMetric ? "metric" : "flat", proof.bits, proof.escalated,
      list_json(proof.lengths, quoted_text), list_json(proof.radii, quoted_text));
  if (!proof.cone_angles.empty())
    text += ", \"cone_angles\": " + list_json(proof.cone_angles, cone_angle_json);
  if (proof.volume) text += ", \"volume\": " + interval_json(*proof.volume);
  if (!proof.dihedral_angles.empty())
    text += ", \"dihedral_angles\": " + list_json(proof.dihedral_angles, [](const auto& angles) {
              return list_json(angles, interval_json);
            });
  if (!proof.flat.empty())
    text += ", \"flat_tetrahedra\": " +
            list_json(proof.flat, [](std::size_t t) { return std::to_string(t); });
  return text + "}";
}

bool looks_like_proof(std::string_view text) {
  const json document = json::parse(text, nullptr, false);
  if (!document.is_object()) return false;
  if (document.contains("radii")) return true;
  const auto certificate = document.find("certificate");
  return document.contains("proof") && (certificate == document.end() || certificate->is_null() ||
                                        document["proof"].contains("radii"));
}

ProofText parse_proof(std::string_view text) {
  const json document = parse_object(text);
  const json& object = proof_member(document);
  if (!object.is_object()) refuse("\"proof\"", "an object");
  ProofText proof;
  const json& proved = member(object, "proved", "true or false");
  if (!proved.is_boolean()) refuse("\"proved\"", "true or false");
  if (!proved.get<bool>()) throw InvalidInput("proof: it says itself that nothing is proved");
  proof.proved = true;
  constexpr std::string_view kKinds = R"("strong-convexity" or "interval-newton")";
  const json& kind = member(object, "kind", kKinds);
  if (kind != kStrongConvexity && kind != kIntervalNewton) refuse("\"kind\"", kKinds);
  proof.interval_newton = kind == kIntervalNewton;
  proof.bits = static_cast<long>(read_count(object, "bits", 53));
  proof.escalated = read_count(object, "escalated", 0);
  const json& claim = member(object, "claim", R"("metric" or "flat")");
  if (claim != "metric" && claim != "flat") refuse("\"claim\"", R"("metric" or "flat")");
  proof.claim = claim == "metric" ? Proof::Claim::kMetric : Proof::Claim::kFlat;
  if (const auto angles = object.find("cone_angles"); angles != object.end()) {
    for (const std::string& angle : read_texts(object, "cone_angles", kTexts))
      proof.cone_angles.push_back(read_cone_angle(angle, proof.cone_angles.size()));
  }
  proof.lengths = read_texts(object, "lengths", kTexts);
  proof.radii = read_texts(object, "radii", kTexts);
  // Here, where an error names the file.
  for (const auto* texts : {&proof.lengths, &proof.radii})
    for (const std::string& number : *texts) detail::read_number(number);
  if (const auto volume = object.find("volume"); volume != object.end())
    proof.volume = read_interval(*volume, "\"volume\"");
  if (const auto angles = object.find("dihedral_angles"); angles != object.end()) {
    if (!angles->is_array()) refuse("\"dihedral_angles\"", "an array, one entry a tetrahedron");
    for (const json& six : *angles) {
      const std::string place =
          fmt::format("angles of tetrahedron {}", proof.dihedral_angles.size());
      if (!six.is_array() || six.size() != 6) refuse(place, "an array of 6 intervals");
      auto& row = proof.dihedral_angles.emplace_back();
      for (std::size_t e = 0; e < 6; ++e) row[e] = read_interval(six[e], place);
    }
  }
  if (const auto flat = object.find("flat_tetrahedra"); flat != object.end()) {
    proof.flat = detail::read_numbers(*flat, "\"flat_tetrahedra\"");
  }
  return proof;
}

}  // namespace tripus::structure
