#include "topology/formats/formats.hpp"

#include <algorithm>
#include <utility>

#include "base/compression.hpp"
#include "base/error.hpp"
#include "topology/detail/text.hpp"

namespace tripus::topology {
namespace {

/// What a compressed text may hold at most.
constexpr std::size_t kLargestText = std::size_t{1} << 30;

const Format* find_format(std::string_view text) {
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  text = detail::trimmed(text);
  if (text.empty()) return nullptr;
  for (const Format& format : formats())
    if (format.matches(text)) return &format;
  return nullptr;
}

/// ", starting with ...", if that is something to read.
std::string beginning(std::string_view text) {
  auto rest = detail::trimmed(text);
  const std::string_view line = detail::take_line(rest).substr(0, 64);
  const bool is_text =
      std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; });
  return is_text ? ", starting with " + quoted(std::string(line)) : "";
}

}  // namespace

std::string_view detect_format(std::string_view text) {
  if (is_gzip(text)) return kGzip;
  const Format* format = find_format(text);
  return format ? format->name : "";
}

std::string format_names() {
  std::string names;
  for (const Format& each : formats())
    names += (names.empty() ? "" : ", ") + std::string(each.name);
  return names;
}

std::vector<NamedGluings> read_triangulations(std::string_view text) {
  if (is_gzip(text)) {
    const std::string content = gunzip(text, kLargestText);
    if (is_gzip(content)) throw InvalidInput("the data are gzip-compressed twice");
    return read_triangulations(content);
  }
  if (detail::trimmed(text).empty())
    throw InvalidInput("the input is empty; expected a triangulation");
  const Format* format = find_format(text);
  if (!format)
    throw InvalidInput("unrecognised input" + beginning(text) +
                       "; expected one of: " + format_names());
  text.remove_prefix(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  return format->read(text);
}

NamedGluings read_triangulation(std::string_view text) {
  std::vector<NamedGluings> all = read_triangulations(text);
  if (all.size() == 1) return std::move(all.front());
  throw InvalidInput("there are " + std::to_string(all.size()) +
                     " triangulations in it; choose one by its label: " + label_list(all));
}

std::string label_list(const std::vector<NamedGluings>& all) {
  constexpr std::size_t kMostShown = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(all.size(), kMostShown); ++i)
    list += (i == 0 ? "" : ", ") + quoted(all[i].name);
  if (all.size() > kMostShown) list += " and " + std::to_string(all.size() - kMostShown) + " more";
  return list;
}

NamedGluings pick_triangulation(std::vector<NamedGluings> all, std::string_view label) {
  const auto has_label = [&](const NamedGluings& each) { return each.name == label; };
  const auto count = std::count_if(all.begin(), all.end(), has_label);
  if (count > 1)
    throw InvalidInput(std::to_string(count) + " triangulations have the label " +
                       quoted(std::string(label)) + "; choose by number, from 1 to " +
                       std::to_string(all.size()));
  if (count == 1) return std::move(*std::find_if(all.begin(), all.end(), has_label));
  const auto number = detail::parse_integer(label);
  if (number && *number >= 1 && static_cast<std::uint64_t>(*number) <= all.size())
    return std::move(all[static_cast<std::size_t>(*number - 1)]);
  throw InvalidInput("no triangulation has the label " + quoted(std::string(label)) +
                     "; there are " + label_list(all));
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
    // As a shell would take them: '5_1 theta'.
    if (line.size() > 2 && (line.front() == '\'' || line.front() == '"') &&
        line.find(line.front(), 1) == line.size() - 1)
      line = line.substr(1, line.size() - 2);
    if (!line.empty()) lines.push_back({number, std::string(line)});
  }
  return lines;
}

}  // namespace tripus::topology
