#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/detail/guarded_json.hpp"
#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/formats.hpp"
#include "topology/triangulation.hpp"
#include "topology/work_size.hpp"

namespace tripus::topology {
namespace {

using nlohmann::json;

std::string place(std::size_t t, std::size_t f) {
  return "JSON: face " + std::to_string(f) + " of tetrahedron " + std::to_string(t) + ": ";
}

/// What a wrong value looks like, short enough for a message.
std::string shown(const json& value) {
  if (value.is_object() || value.is_array())
    return std::string("an ") + value.type_name() + " of " + std::to_string(value.size());
  return quoted(value.dump(-1, ' ', true, json::error_handler_t::replace));
}

void read_face(const json& entry, std::size_t t, std::size_t f, Gluings& gluings) {
  if (entry.is_null()) return;
  if (!entry.is_array() || entry.size() != 2)
    throw InvalidInput(place(t, f) + "expected [tetrahedron, \"permutation\"] or null, found " +
                       shown(entry));
  const std::size_t count = gluings.tetrahedron_count();
  if (!entry[0].is_number_unsigned() || entry[0].get<std::uint64_t>() >= count)
    throw InvalidInput(place(t, f) + "tetrahedron " + shown(entry[0]) + "; expected 0 to " +
                       std::to_string(count - 1));
  const auto perm = entry[1].is_string()
                        ? detail::parse_perm(entry[1].get_ref<const std::string&>())
                        : std::nullopt;
  if (!perm)
    throw InvalidInput(place(t, f) + "permutation " + shown(entry[1]) +
                       "; expected a word such as \"1230\", the images of 0, 1, 2, 3");
  gluings.set_one_side(t, static_cast<int>(f), entry[0].get<TetrahedronIndex>(), *perm);
}

/// One label an edge class: 3, 2.5, "5/2", 0 for a parabolic edge.
std::vector<ConeAngle> read_cone_orders(const json& list, const Gluings& gluings) {
  const std::size_t edges = Triangulation(gluings).edge_count();
  if (!list.is_array() || list.size() != edges)
    throw InvalidInput("JSON: \"cone_orders\" is " + shown(list) + "; expected " +
                       std::to_string(edges) + " cone orders, one an edge class");
  std::vector<ConeAngle> angles;
  for (const json& entry : list) {
    try {
      angles.push_back(
          parse_cone_order(entry.is_string() ? entry.get_ref<const std::string&>() : entry.dump()));
    } catch (const InvalidInput& error) {
      throw InvalidInput("JSON: cone order of edge class " + std::to_string(angles.size()) + ": " +
                         error.what());
    }
  }
  return angles;
}

/// Reads {"name": ..., "gluings": [...]} as it comes, without a document in memory: that takes a
/// kilobyte a tetrahedron, and its destructor, which must not fail, asks for memory too. What is
/// not as it should be, and labels, are left to the reader of documents, who says what is wrong.
class PlainReader : public nlohmann::json_sax<json> {
 public:
  NamedGluings take() {
    result_.gluings.resize(sides_ / 4);
    return std::move(result_);
  }
  bool has_gluings() const { return done_; }

  bool key(string_t& name) override {
    if (depth_ != 1) return true;
    key_ = name;
    const bool again = (key_ == "gluings" && done_) || (key_ == "name" && is_named_);
    is_named_ = is_named_ || key_ == "name";
    return key_ != "cone_orders" && !again;
  }
  bool start_object(std::size_t) override { return !in_table() && open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override {
    if (!open()) return false;
    if (!in_table()) return true;
    if (depth_ == kRow) return sides_ % 4 == 0;
    if (depth_ == kFace) entries_ = 0;
    return depth_ <= kFace;
  }
  bool end_array() override {
    if (in_table() && depth_ == kFace && (entries_ != 2 || !add_side(false))) return false;
    if (in_table() && depth_ == kRow && sides_ != row_begins_ + 4) return false;
    if (in_table() && depth_ == kRow) row_begins_ = sides_;
    if (in_table() && depth_ == kTable) done_ = true;
    return close();
  }
  bool null() override { return !in_table() || (depth_ == kRow && add_side(true)); }
  bool number_unsigned(number_unsigned_t value) override {
    if (!in_table()) return depth_ > 1 || key_ != "name";
    other_ = value;
    return depth_ == kFace && entries_++ == 0 && value < kMaxTetrahedra;
  }
  bool string(string_t& value) override {
    if (!in_table()) {
      if (depth_ == 1 && key_ == "name") result_.name = value;
      return true;
    }
    perm_ = detail::parse_perm(value);
    return depth_ == kFace && entries_++ == 1 && perm_;
  }
  bool boolean(bool) override { return outside(); }
  bool number_integer(number_integer_t) override { return outside(); }
  bool number_float(number_float_t, const string_t&) override { return outside(); }
  bool binary(binary_t&) override { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  /// Depths of the table, of the row of a tetrahedron and of a face.
  static constexpr std::size_t kTable = 2, kRow = 3, kFace = 4;

  bool in_table() const { return key_ == "gluings" && depth_ >= 1; }
  bool outside() const { return !in_table() && (depth_ > 1 || key_ != "name"); }
  bool open() {
    ++depth_;
    return depth_ <= tripus::detail::kDeepestJson && (depth_ > 1 || !in_table());
  }
  bool close() {
    --depth_;
    if (depth_ == 1) key_.clear();
    return true;
  }
  bool add_side(bool open) {
    const std::size_t t = sides_ / 4;
    if (t >= kMaxTetrahedra) return false;
    if (t == result_.gluings.tetrahedron_count()) {
      note_work_size(t + 1);
      result_.gluings.resize(t + 1 + t / 2);
    }
    if (!open)
      result_.gluings.set_one_side(t, static_cast<int>(sides_ % 4),
                                   static_cast<TetrahedronIndex>(other_), *perm_);
    ++sides_;
    return true;
  }

  NamedGluings result_;
  std::string key_;  // at the top level
  std::size_t depth_ = 0;
  bool done_ = false, is_named_ = false;
  std::size_t sides_ = 0, row_begins_ = 0;
  int entries_ = 0;  // of a face
  std::uint64_t other_ = 0;
  std::optional<Perm4> perm_;
};

std::optional<NamedGluings> read_plain(std::string_view text) {
  PlainReader reader;
  if (!json::sax_parse(text.begin(), text.end(), &reader) || !reader.has_gluings())
    return std::nullopt;
  NamedGluings result = reader.take();
  const std::size_t count = result.gluings.tetrahedron_count();
  for (std::size_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f)
      if (!result.gluings.is_open(t, f) && result.gluings.neighbour(t, f) >= count)
        return std::nullopt;
  require_consistent(result.gluings, OpenFaces::kAllowed);
  return result;
}

}  // namespace

NamedGluings read_json(std::string_view text) {
  if (auto plain = read_plain(text)) return *std::move(plain);
  const json document = tripus::detail::parse_guarded_json(text, "an object {\"gluings\": [...]}");
  const auto table = document.is_object() ? document.find("gluings") : document.end();
  if (!document.is_object() || table == document.end() || !table->is_array())
    throw InvalidInput("JSON: expected an object with an array \"gluings\", found " +
                       shown(document));
  NamedGluings result;
  if (const auto name = document.find("name"); name != document.end()) {
    if (!name->is_string())
      throw InvalidInput("JSON: \"name\" is " + shown(*name) + "; expected a string");
    result.name = name->get<std::string>();
  }
  result.gluings = Gluings(table->size());
  for (std::size_t t = 0; t < table->size(); ++t) {
    const json& row = (*table)[t];
    if (!row.is_array() || row.size() != 4)
      throw InvalidInput("JSON: tetrahedron " + std::to_string(t) + ": " + shown(row) +
                         "; expected an array of its four faces");
    for (std::size_t f = 0; f < 4; ++f) read_face(row[f], t, f, result.gluings);
  }
  require_consistent(result.gluings, OpenFaces::kAllowed);
  if (const auto orders = document.find("cone_orders"); orders != document.end())
    result.cone_angles = read_cone_orders(*orders, result.gluings);
  return result;
}

std::string write_json(const NamedGluings& triangulation) {
  const Gluings& gluings = triangulation.gluings;
  std::string out = "{";
  if (!triangulation.name.empty())
    out += "\"name\": " +
           json(triangulation.name).dump(-1, ' ', false, json::error_handler_t::replace) + ", ";
  out += "\"gluings\": [";
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
    out += t == 0 ? "[" : ", [";
    for (int f = 0; f < 4; ++f) {
      if (f > 0) out += ", ";
      if (gluings.is_open(t, f)) {
        out += "null";
        continue;
      }
      const auto letters = word(gluings.gluing(t, f));
      out += "[" + std::to_string(gluings.neighbour(t, f)) + ", \"";
      out.append(letters.begin(), letters.end());
      out += "\"]";
    }
    out += "]";
  }
  out += "]";
  if (!all_full(triangulation.cone_angles)) {
    out += ", \"cone_orders\": [";
    for (std::size_t e = 0; e < triangulation.cone_angles.size(); ++e)
      out += (e > 0 ? ", \"" : "\"") + triangulation.cone_angles[e].order_text() + "\"";
    out += "]";
  }
  return out + "}\n";
}

}  // namespace tripus::topology

namespace tripus::topology::registered_formats {
namespace {

bool starts_json(std::string_view text) { return text.front() == '{' || text.front() == '['; }

}  // namespace

std::span<const Format> json() {
  static constexpr Format kRows[] = {{kJson, starts_json, read_one<read_json>, 0}};
  return kRows;
}

}  // namespace tripus::topology::registered_formats
