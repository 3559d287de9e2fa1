#include "viewer/web/page.hpp"

#include <fmt/format.h>

#include "viewer/web/detail/assets.hpp"

namespace tripus::viewer {
namespace {

/// It asks for nothing and sends nothing.
constexpr const char* kPolicy =
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
    "'unsafe-inline'; script-src 'unsafe-inline'; img-src data: blob:\">";

}  // namespace

std::string page_html(const PageOptions& options, const topology::Triangulation& triangulation,
                      const structure::Report& report, const embedding::Embedding& embedding) {
  const std::string data = page_data(options, triangulation, report, embedding);
  std::string shaders, scripts;
  for (const detail::Asset& asset : detail::web_assets()) {
    if (asset.kind == detail::AssetKind::kShader) {
      shaders += fmt::format("<script type=\"x-shader/glsl\" id=\"shader-{}\">{}</script>\n",
                             asset.name, asset.text);
    } else if (asset.kind == detail::AssetKind::kScript) {
      scripts += asset.text;
    }
  }
  const std::string name = detail::escape_html(options.name.empty() ? "A manifold" : options.name);
  const std::string back = options.gallery.empty()
                               ? std::string()
                               : fmt::format("<a id=\"gallery\" href=\"{}\">All manifolds</a>",
                                             detail::escape_html(options.gallery));
  const auto part = [](std::string_view file) { return std::string(detail::web_asset(file)); };
  return detail::fill_template(
      detail::web_asset("page.html"),
      {{"head",
        detail::page_head(name + " - Tripus", {"theme.css", "view.css", "style.css"}, kPolicy)},
       {"heading", name},
       {"back", back},
       {"stage", part("stage.html")},
       {"controls", part("controls.html")},
       {"help", part("help.html")},
       {"shaders", shaders},
       {"data", data},
       {"script", "'use strict';\n(() => {\n" + scripts + "})();"}});
}

}  // namespace tripus::viewer
