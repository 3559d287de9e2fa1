#include "structure/proof/canonical_proof_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/detail/guarded_json.hpp"
#include "base/error.hpp"
#include "structure/proof/detail/checked_field.hpp"
#include "structure/proof/detail/proof_json.hpp"

namespace tripus::structure {
namespace {

using detail::member;
using detail::read_texts;
using detail::refuse;
using nlohmann::json;

std::string quoted_json(const std::string& text) { return json(text).dump(); }

std::string faces_json(const std::vector<FaceOfTetrahedron>& faces) {
  return detail::list_json(
      faces, [](const auto& face) { return fmt::format("[{}, {}]", face.tetrahedron, face.face); });
}

std::string field_json(const ExactField& field) {
  const auto root_json = [](const ExactField::Root& root) {
    return fmt::format("[{}, {}]", quoted_json(root.factor),
                       detail::list_json(root.of, [](std::size_t t) { return std::to_string(t); }));
  };
  std::string text = fmt::format(
      "{{\"polynomial\": {}, \"root\": {}, \"gram\": {}, \"square_roots\": {}",
      quoted_json(field.polynomial), detail::interval_json(field.root),
      detail::list_json(field.gram, quoted_json), detail::list_json(field.roots, root_json));
  if (!field.horospheres.empty())
    text += ", \"horospheres\": " + detail::list_json(field.horospheres, quoted_json);
  return text + "}";
}

std::vector<FaceOfTetrahedron> read_faces(const json& object, const char* name) {
  constexpr std::string_view kShape = "an array of faces, each [tetrahedron, 0 to 3]";
  const json& list = member(object, name, kShape);
  if (!list.is_array()) refuse(fmt::format("\"{}\"", name), kShape);
  std::vector<FaceOfTetrahedron> faces;
  for (const json& item : list) {
    const auto numbers = detail::read_numbers(item, fmt::format("\"{}\" {}", name, faces.size()));
    if (numbers.size() != 2 || numbers[1] > 3)
      refuse(fmt::format("\"{}\" {}", name, faces.size()), "a face: [tetrahedron, 0 to 3]");
    faces.push_back({numbers[0], static_cast<int>(numbers[1])});
  }
  return faces;
}

std::string read_text(const json& object, const char* name, std::string_view shape) {
  const json& text = member(object, name, shape);
  if (!text.is_string()) refuse(fmt::format("\"{}\"", name), shape);
  return text.get<std::string>();
}

ExactField read_field(const json& object) {
  if (!object.is_object()) refuse("\"field\"", "an object");
  ExactField field;
  field.polynomial = read_text(object, "polynomial", "a polynomial in x");
  field.root = detail::read_interval(member(object, "root", "two texts"), "\"root\"");
  constexpr std::string_view kPolynomials = "an array of polynomials in x";
  field.gram = read_texts(object, "gram", kPolynomials);
  constexpr std::string_view kRoots = "an array of [polynomial, [tetrahedron, ...]]";
  const json& roots = member(object, "square_roots", kRoots);
  if (!roots.is_array()) refuse("\"square_roots\"", kRoots);
  for (const json& root : roots) {
    const std::string place = fmt::format("\"square_roots\" {}", field.roots.size());
    if (!root.is_array() || root.size() != 2 || !root[0].is_string())
      refuse(place, "[polynomial, [tetrahedron, ...]]");
    field.roots.push_back({root[0].get<std::string>(), detail::read_numbers(root[1], place)});
  }
  if (object.contains("horospheres"))
    field.horospheres = read_texts(object, "horospheres", kPolynomials);
  // Here, where an error names the file.
  const detail::Rational lower(field.root.lower), upper(field.root.upper);
  const detail::RationalPolynomial f(field.polynomial);
  for (const auto* texts : {&field.gram, &field.horospheres})
    for (const std::string& text : *texts) const detail::RationalPolynomial read(text);
  for (const ExactField::Root& root : field.roots)
    const detail::RationalPolynomial read(root.factor);
  return field;
}

/// The object itself or the "proof" of an answer, if it is one of a canonical decomposition.
const json* canonical_member(const json& document) {
  if (!document.is_object()) return nullptr;
  const auto found = document.find("proof");
  const json& object = found == document.end() ? document : *found;
  if (!object.is_object()) return nullptr;
  const auto kind = object.find("kind");
  return kind != object.end() && *kind == kCanonicalDecomposition ? &object : nullptr;
}

}  // namespace

std::string to_json(const CanonicalProofText& proof) {
  std::string text =
      fmt::format("{{\"kind\": \"{}\", \"proved\": {}", kCanonicalDecomposition, proof.proved);
  if (!proof.proved) text += ", \"reason\": " + quoted_json(proof.reason);
  text += fmt::format(", \"triangulation\": {}, \"unproved_faces\": {}, \"inner_faces\": {}",
                      quoted_json(proof.triangulation), faces_json(proof.unproved),
                      faces_json(proof.inside));
  if (proof.field) text += ", \"field\": " + field_json(*proof.field);
  return text + ", \"metric\": " + to_json(proof.metric) + "}";
}

bool looks_like_canonical_proof(std::string_view text) {
  return canonical_member(json::parse(text, nullptr, false)) != nullptr;
}

CanonicalProofText parse_canonical_proof(std::string_view text) {
  constexpr std::string_view kExpected =
      "an object with the \"proof\" of a canonical decomposition, such as an answer of `tripus "
      "canonize --prove --json`";
  const json document = tripus::detail::parse_guarded_json(text, kExpected);
  const json* object = canonical_member(document);
  if (object == nullptr) throw InvalidInput(fmt::format("JSON: expected {}", kExpected));
  CanonicalProofText proof;
  const json& proved = member(*object, "proved", "true or false");
  if (!proved.is_boolean()) refuse("\"proved\"", "true or false");
  if (!proved.get<bool>()) throw InvalidInput("proof: it says itself that nothing is proved");
  proof.proved = true;
  proof.triangulation = read_text(*object, "triangulation", "a signature");
  proof.unproved = read_faces(*object, "unproved_faces");
  proof.inside = read_faces(*object, "inner_faces");
  if (const auto field = object->find("field"); field != object->end())
    proof.field = read_field(*field);
  proof.metric = parse_proof(member(*object, "metric", "the proof of a metric").dump());
  return proof;
}

}  // namespace tripus::structure
