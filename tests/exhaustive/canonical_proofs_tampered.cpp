// Proofs of canonical decompositions in which one thing was changed: all are refused, by name.
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "canonical/proved.hpp"
#include "topology/isosig.hpp"

namespace tripus::canonical {
namespace {

using nlohmann::json;
using structure::CanonicalProofText;

struct Made {
  topology::Triangulation triangulation;
  json proof;
};

Made made(const std::string& signature) {
  const auto answer = canonize(topology::Triangulation(topology::decode_isosig(signature)));
  const CanonicalProof proof = prove_canonical(*answer.manifold);
  EXPECT_TRUE(proof.proved) << proof.reason;
  return {topology::Triangulation(topology::decode_isosig(proof.triangulation)),
          json::parse(to_json(proof_text(proof)))};
}

/// Why the proof is not taken; empty if it is.
std::string refusal(const Made& made) {
  try {
    const CanonicalProofText text = structure::parse_canonical_proof(made.proof.dump());
    return structure::check_canonical_proof(made.triangulation, {}, text).reason;
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

class Tampering {
 public:
  explicit Tampering(const std::string& signature) : made_(made(signature)) {
    EXPECT_EQ(refusal(made_), "");
  }
  const json& proof() const { return made_.proof; }
  std::size_t count() const { return count_; }

  /// Expects that `change` makes it invalid, with `says` in the reason.
  void expect(const std::string& what, const std::string& says,
              const std::function<void(json&)>& change) {
    Made changed = made_;
    change(changed.proof);
    ASSERT_NE(changed.proof, made_.proof) << what;
    const std::string reason = refusal(changed);
    EXPECT_NE(reason.find(says), std::string::npos) << what << ": " << reason;
    EXPECT_FALSE(reason.empty()) << what;
    ++count_;
  }

 private:
  Made made_;
  std::size_t count_ = 0;
};

std::string with(const json& text, const std::string& rest) {
  return text.get<std::string>() + rest;
}

/// Every member of the field, of the lists of faces and of the metric.
std::size_t tamper_with_all(const std::string& signature) {
  SCOPED_TRACE(signature);
  Tampering t(signature);
  const json& field = t.proof()["field"];
  for (const char* more : {"+1", "-1/1000000007", "+x", "+x^30"})
    t.expect("polynomial", "",
             [&](json& p) { p["field"]["polynomial"] = with(p["field"]["polynomial"], more); });
  t.expect("root", "does not change its sign",
           [](json& p) { p["field"]["root"][0] = p["field"]["root"][1]; });
  t.expect("root", "does not change its sign", [](json& p) {
    p["field"]["root"] = {"1000000", "1000001"};
  });
  for (std::size_t e = 0; e < field["gram"].size(); ++e)
    for (const char* more : {"+1", "-1/1000000000000000000000000000000", "+x", "-2"})
      t.expect("gram", "",
               [&](json& p) { p["field"]["gram"][e] = with(p["field"]["gram"][e], more); });
  for (std::size_t k = 0; k < field["square_roots"].size(); ++k) {
    for (const char* more : {"+1", "-1/1000000000000000000000000000000", "-3"})
      t.expect("square root", "square root", [&](json& p) {
        p["field"]["square_roots"][k][0] = with(p["field"]["square_roots"][k][0], more);
      });
    t.expect("square root", "square root", [&](json& p) {
      auto& of = p["field"]["square_roots"][k][1];
      of = of.empty() ? json{0} : json::array();
    });
    t.expect("square root", "square root", [&](json& p) {
      p["field"]["square_roots"][k][1] = {field["square_roots"].size() + 5};
    });
  }
  if (field.contains("horospheres"))
    for (std::size_t v = 0; v < field["horospheres"].size(); ++v)
      t.expect("horosphere", "horosphere", [&](json& p) { p["field"]["horospheres"][v] = "-1"; });
  for (const char* list : {"gram", "square_roots"})
    t.expect(list, "the field has", [&](json& p) { p["field"][list].erase(0); });

  const json& faces = t.proof()["inner_faces"];
  for (std::size_t k = 0; k < faces.size(); ++k)
    t.expect("an inner face less", "its tilt sum < 0 fails",
             [&](json& p) { p["inner_faces"].erase(k); });
  t.expect("an inner face twice", "named twice",
           [&](json& p) { p["inner_faces"].push_back(p["inner_faces"][0]); });
  t.expect("an inner face that is none", "there is no tetrahedron", [&](json& p) {
    p["inner_faces"].push_back({99, 0});
  });
  t.expect("a face that is none", "[tetrahedron, 0 to 3]", [&](json& p) {
    p["inner_faces"].push_back({0, 4});
  });
  // Every other face as an inner one.
  for (std::size_t i = 0; i < field["square_roots"].size(); ++i)
    for (int f = 0; f < 4; ++f)
      t.expect("an inner face more", "of tetrahedron", [&](json& p) {
        bool known = false;
        for (const auto& face : faces) known = known || face == json{i, f};
        if (known) return p["inner_faces"].clear();  // without all of them, instead
        p["inner_faces"].push_back({i, f});
      });
  t.expect("no field", "no field shows", [](json& p) { p.erase("field"); });
  t.expect("unproved faces", "not proved", [](json& p) { p["unproved_faces"] = {{0, 0}}; });
  t.expect("not proved", "says itself", [](json& p) { p["proved"] = false; });

  json& metric = const_cast<json&>(t.proof())["metric"];
  for (std::size_t e = 0; e < metric["lengths"].size(); ++e) {
    // One length alone may be that of another horosphere, and with it the metric is the same.
    t.expect("length", "the metric: ", [&](json& p) {
      p["metric"]["lengths"][e] = "0.7";
      p["metric"]["lengths"][0] = "0.71";
      p["metric"]["radii"][0] = "1e-20";
    });
    t.expect("radius", "the metric: ", [&](json& p) { p["metric"]["radii"][e] = "1e-40"; });
  }
  t.expect("volume", "the metric: ", [](json& p) { p["metric"]["volume"] = {"1", "2"}; });
  t.expect("claim", "", [](json& p) { p["metric"]["claim"] = "flat"; });
  t.expect("cone angles", "other cone angles", [&](json& p) {
    p["metric"]["cone_angles"] = std::vector<std::string>(metric["lengths"].size(), "1");
  });
  return t.count();
}

// Of several cusps each has its own horosphere.
TEST(TamperedCanonicalProofs, WithOtherHorospheresAreRefused) {
  Tampering t("eLPkbdcddbaaab");
  for (std::size_t v = 0; v < 3; ++v)
    t.expect("horosphere", "has not the area of the others", [&](json& p) {
      p["field"]["horospheres"][v] = with(p["field"]["horospheres"][v], "+1");
    });
}

// Where the first terms alone are 0: there are no inner faces, but without the field the sign is
// not shown.
TEST(TamperedCanonicalProofs, WithoutTheFieldOfFirstTermsAreRefused) {
  Tampering t("eLPkbdcddmgggo");
  EXPECT_TRUE(t.proof()["inner_faces"].empty());
  t.expect("no field", "its tilt sum < 0 fails", [](json& p) { p.erase("field"); });
}

// An octahedron, pyramids, a field of degree 4, one cusp, several cusps, cusps beside a boundary.
TEST(TamperedCanonicalProofs, AreRefused) {
  std::size_t count = 0;
  for (const char* signature :
       {"eLAkbccddelben", "eLMkbbddddhahu", "eLAkbccddemoen", "eLAkbccdddindk", "eLPkbcdddjssaj",
        "eLPkbdcddbaaab", "eLAkccbdddejdw"})
    count += tamper_with_all(signature);
  std::printf("%zu changed proofs\n", count);
  EXPECT_GT(count, 200u);
}

TEST(TamperedCanonicalProofs, AreRefusedByFormAsWell) {
  const Made octahedron = made("eLAkbccddelben");
  const auto expect = [&](const std::string& path, const json& value, const std::string& says) {
    Made changed = octahedron;
    changed.proof[json::json_pointer(path)] = value;
    const std::string reason = refusal(changed);
    EXPECT_NE(reason.find(says), std::string::npos) << path << " " << value << ": " << reason;
  };
  for (const char* bad : {"", "x+", "y", "1/0", "1/0*x", "x^", "x^-1", "x^999999999999", "2x",
                          "x x", "1.5", "--x", "x**2"})
    expect("/field/gram/0", bad, "is no polynomial in x");
  expect("/field/gram/0", std::string(5000, '9') + "*x", "bits, and there can be");
  expect("/field/polynomial", std::string(200000, 'x'), "is no polynomial in x");
  expect("/field/polynomial", "5", "constant");
  expect("/field/polynomial", "0", "constant");
  for (const char* bad : {"", "-", ".", "1e5", "0x1p3", "nan", "1.2.3"})
    expect("/field/root/0", bad, "is no decimal number");
  expect("/field/root", json::array({"1"}), "two texts");
  expect("/field/root", 7, "two texts");
  expect("/field", 7, "an object");
  expect("/field/gram", "x", "an array of polynomials");
  expect("/field/gram/0", 7, "a text");
  expect("/field/square_roots", 7, "an array of");
  expect("/field/square_roots/0", json::array({"1"}), "[polynomial, [tetrahedron, ...]]");
  expect("/field/square_roots/0/1", json::array({-1}), "an array of numbers");
  expect("/field/horospheres", json::array({"1", "1"}), "horospheres for");
  expect("/inner_faces", 7, "an array of faces");
  expect("/inner_faces/0", json::array({0, -1}), "an array of numbers");
  expect("/inner_faces/0", json::array({0}), "a face");
  expect("/triangulation", 7, "a signature");
  expect("/metric", 7, "\"proof\"");
  expect("/proved", 1, "true or false");
  // The proof of another manifold, which has the same equations.
  Made other = octahedron;
  other.triangulation = topology::Triangulation(topology::decode_isosig("eLAkbccddelber"));
  EXPECT_NE(refusal(other).find("it is about the triangulation \"eLAkbccddelben\", and this is"),
            std::string::npos);
}

}  // namespace
}  // namespace tripus::canonical
