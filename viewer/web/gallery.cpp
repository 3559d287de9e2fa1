#include "viewer/web/gallery.hpp"

#include <fmt/format.h>

#include "viewer/web/detail/assets.hpp"

namespace tripus::viewer {
namespace {

using detail::escape_html;

std::string card(const GalleryEntry& entry) {
  return fmt::format(
      "<li data-line=\"{}\" data-volume=\"{}\" data-size=\"{}\"><a href=\"{}\">"
      "<img src=\"{}\" width=\"{}\" height=\"{}\" loading=\"lazy\" alt=\"\">"
      "<b>{}</b><span class=\"note\">volume {:.9f}<br>{} {}; {}</span></a></li>\n",
      entry.line, entry.volume, entry.tetrahedron_count, escape_html(entry.page),
      escape_html(entry.picture), kThumbnailWidth, kThumbnailHeight, escape_html(entry.name),
      entry.volume, entry.tetrahedron_count,
      entry.tetrahedron_count == 1 ? "tetrahedron" : "tetrahedra", escape_html(entry.boundary));
}

std::string problem_line(const GalleryEntry& entry) {
  return fmt::format("<li>line {}: <b>{}</b>: {}</li>\n", entry.line, escape_html(entry.name),
                     escape_html(entry.problem));
}

}  // namespace

std::string gallery_html(const std::string& title, std::span<const GalleryEntry> entries) {
  std::string cards, problems;
  std::size_t count = 0;
  for (const GalleryEntry& entry : entries) {
    if (entry.problem.empty()) {
      cards += card(entry);
      ++count;
    } else {
      problems += problem_line(entry);
    }
  }
  if (!problems.empty()) {
    problems = fmt::format("<section><h2>Without a page ({})</h2>\n<ul>\n{}</ul></section>",
                           entries.size() - count, problems);
  }
  return detail::fill_template(
      detail::web_asset("gallery.html"),
      {{"head",
        detail::page_head(escape_html(title), {"theme.css", "cards.css", "gallery.css"}, "")},
       {"title", escape_html(title)},
       {"count", fmt::format("{} {}", count, count == 1 ? "manifold" : "manifolds")},
       {"cards", cards},
       {"problems", problems}});
}

}  // namespace tripus::viewer
