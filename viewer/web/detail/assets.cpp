#include "viewer/web/detail/assets.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/version.hpp"

namespace tripus::viewer::detail {
namespace {

/// Well-formed UTF-8 with U+FFFD for all else.
std::string clean_utf8(std::string_view text) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  return nlohmann::json::parse(nlohmann::json(text).dump(-1, ' ', false, kReplace))
      .get<std::string>();
}

}  // namespace

std::string_view web_asset(std::string_view name) {
  for (const Asset& asset : web_assets()) {
    if (asset.name == name) return asset.text;
  }
  throw InternalError("the page has no part " + std::string(name));
}

std::string fill_template(std::string_view text,
                          const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string out;
  while (true) {
    const std::size_t open = text.find("{{");
    out += text.substr(0, open);
    if (open == std::string_view::npos) return out;
    const std::size_t close = text.find("}}", open);
    if (close == std::string_view::npos) throw InternalError("a page template has no }}");
    const std::string_view key = text.substr(open + 2, close - open - 2);
    const auto value =
        std::ranges::find(values, key, &std::pair<std::string_view, std::string>::first);
    if (value == values.end()) throw InternalError("a page template asks for " + std::string(key));
    out += value->second;
    text.remove_prefix(close + 2);
  }
}

std::string page_head(std::string title, std::initializer_list<std::string_view> sheets,
                      std::string policy) {
  std::string style;
  for (const std::string_view sheet : sheets) style += web_asset(sheet);
  return fill_template(web_asset("head.html"), {{"policy", std::move(policy)},
                                                {"version", std::string(kVersion)},
                                                {"title", std::move(title)},
                                                {"style", std::move(style)}});
}

std::string escape_html(std::string_view text) {
  std::string out;
  for (const char c : clean_utf8(text)) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        if (byte < 0x20 || byte == 0x7f) {
          out += "\xef\xbf\xbd";
        } else {
          out += c;
        }
    }
  }
  return out;
}

std::string json_string(std::string_view text) {
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  std::string out;
  for (const char c : nlohmann::json(text).dump(-1, ' ', true, kReplace)) {
    switch (c) {
      case '<':
        out += "\\u003c";
        break;
      case '>':
        out += "\\u003e";
        break;
      case '&':
        out += "\\u0026";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace tripus::viewer::detail
