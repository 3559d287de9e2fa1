#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tripus::viewer::detail {

enum class AssetKind {
  kShader,
  kDesktop,  ///< a shader that no page has
  kScript,
  kText,
};

/// A file of viewer/web or viewer/faces.
struct Asset {
  AssetKind kind;
  std::string_view name;
  std::string_view text;
};

/// All of them, in the order in which a page puts them together.
std::span<const Asset> web_assets();

/// The text of one by name. Throws InternalError if there is none.
std::string_view web_asset(std::string_view name);

/// The template with every {{key}} replaced, in one pass, so that what is put in is never taken for
/// a key. Throws InternalError for a key without a value.
std::string fill_template(std::string_view text,
                          const std::vector<std::pair<std::string_view, std::string>>& values);

/// What stands in the head of every page.
///   title   as HTML
///   sheets  names of the style sheets, in their order
///   policy  a meta element that says what the page may load; empty: whatever it names
std::string page_head(std::string title, std::initializer_list<std::string_view> sheets,
                      std::string policy);

/// Text of a user for the inside of an element or of a quoted attribute: escaped, and what is not
/// UTF-8 or a control character replaced by U+FFFD.
std::string escape_html(std::string_view text);

/// Text of a user as a JSON string, quotes included, that may stand in a script element: no "<"
/// and no "&" is left in it.
std::string json_string(std::string_view text);

}  // namespace tripus::viewer::detail
