#include "topology/formats/formats.hpp"

#include <array>

#include "base/error.hpp"
#include "topology/detail/text.hpp"
#include "topology/formats/json.hpp"
#include "topology/formats/orb.hpp"
#include "topology/formats/regina.hpp"
#include "topology/formats/snappea.hpp"
#include "topology/isosig.hpp"

namespace tripus::topology {
namespace {

struct Format {
  TextFormat id;
  std::string_view name;
  /// Given the text without surrounding white space, not empty.
  bool (*matches)(std::string_view);
  NamedGluings (*read)(std::string_view);
};

bool starts_json(std::string_view text) { return text.front() == '{' || text.front() == '['; }
bool starts_orb(std::string_view text) { return text.starts_with("% orb"); }
bool starts_snappea(std::string_view text) { return text.front() == '%'; }
bool starts_xml(std::string_view text) { return text.front() == '<'; }
bool holds_table(std::string_view text) {
  return text.find("glued to:") != std::string_view::npos ||
         (text.starts_with("Tet") && text.find("face:") != std::string_view::npos);
}

NamedGluings read_isosig(std::string_view text) {
  return {std::string(detail::trimmed(text)), decode_isosig(text), {}};
}

/// The first that matches is taken. A new format is one file and one line here.
constexpr std::array kFormats{
    Format{TextFormat::kJson, "JSON", starts_json, read_json},
    Format{TextFormat::kOrb, "Orb triangulation", starts_orb, read_orb},
    Format{TextFormat::kSnappea, "SnapPea triangulation", starts_snappea, read_snappea},
    Format{TextFormat::kReginaXml, "Regina data file", starts_xml, read_regina_xml},
    Format{TextFormat::kReginaTable, "Regina gluing table", holds_table, read_regina_table},
    Format{TextFormat::kIsosig, "isomorphism signature", looks_like_isosig, read_isosig},
};

bool is_gzip(std::string_view text) { return text.starts_with("\x1f\x8b"); }

const Format* find_format(std::string_view text) {
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  text = detail::trimmed(text);
  if (text.empty()) return nullptr;
  for (const Format& format : kFormats)
    if (format.matches(text)) return &format;
  return nullptr;
}

}  // namespace

TextFormat detect_format(std::string_view text) {
  if (is_gzip(text)) return TextFormat::kGzip;
  const Format* format = find_format(text);
  return format ? format->id : TextFormat::kUnknown;
}

std::string_view format_name(TextFormat format) {
  for (const Format& each : kFormats)
    if (each.id == format) return each.name;
  return format == TextFormat::kGzip ? "gzip data" : "unknown format";
}

NamedGluings read_triangulation(std::string_view text) {
  if (is_gzip(text))
    throw InvalidInput(
        "this is gzip-compressed data; decompress it first (gunzip, or in Regina: save as "
        "uncompressed XML)");
  if (detail::trimmed(text).empty())
    throw InvalidInput("the input is empty; expected a triangulation");
  const Format* format = find_format(text);
  if (!format) {
    std::string known;
    for (const Format& each : kFormats)
      known += (known.empty() ? "" : ", ") + std::string(each.name);
    auto rest = detail::trimmed(text);
    throw InvalidInput("unrecognised input, starting with " +
                       quoted(std::string(detail::take_line(rest).substr(0, 64))) +
                       "; expected one of: " + known);
  }
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  return format->read(text);
}

std::vector<BatchLine> read_batch(std::string_view text) {
  std::vector<BatchLine> lines;
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = detail::take_line(text);
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line[i] == '#' && (i == 0 || detail::is_space(line[i - 1]))) {
        line = line.substr(0, i);
        break;
      }
    line = detail::trimmed(line);
    if (!line.empty()) lines.push_back({number, std::string(line)});
  }
  return lines;
}

}  // namespace tripus::topology
