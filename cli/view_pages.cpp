// Pages for a browser: one, or a gallery of many.
#include "cli/view_pages.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/checksum.hpp"
#include "base/output_file.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/remedies.hpp"
#include "cli/texts.hpp"
#include "manifold/load.hpp"
#include "structure/solve.hpp"
#include "viewer/web/gallery.hpp"
#include "viewer/web/page.hpp"
#include "viewer/web/thumbnail.hpp"

namespace tripus::cli {
namespace {

/// What to call a manifold: its name in the file, or what was typed.
const std::string& name_of(const Subject& subject) {
  return subject.name.empty() ? subject.input : subject.name;
}

std::string page_of(const Subject& subject, const structure::Report& report,
                    const embedding::Embedding& embedding, const PageRequest& request,
                    std::string gallery) {
  const auto discs = discs_for(request.discs, subject, report, embedding);
  return viewer::page_html({.name = name_of(subject),
                            .isosig = subject.isosig.value_or(""),
                            .cells = request.cells,
                            .model = request.model,
                            .discs = discs.get(),
                            .gallery = std::move(gallery)},
                           subject.triangulation, report, embedding);
}

std::string boundary_of(const structure::Report& report) {
  std::string text;
  for (const structure::VertexReport& vertex : report.vertices) {
    if (vertex.kind == topology::VertexKind::kFinite) continue;
    const std::string one = vertex.kind == topology::VertexKind::kIdeal
                                ? "cusp"
                                : fmt::format("genus {}", vertex.genus);
    text += (text.empty() ? "" : ", ") + one;
  }
  return text;
}

std::string as_json(const Subject& subject, const structure::Report& report,
                    const std::string& path, const std::string& file_checksum) {
  JsonText out;
  append_header(out, subject.input);
  append_subject(out, subject);
  append(out, ", \"outcome\": \"geometric\", \"volume\": ");
  append_number(out, report.volume);
  append(out, ", \"file\": ");
  append_string(out, path);
  append(out, ", \"boundary\": ");
  append_string(out, boundary_of(report));
  if (!file_checksum.empty()) append(out, ", \"file_checksum\": \"" + file_checksum + "\"");
  out.push_back('}');
  return fmt::to_string(out);
}

Reply page_written(const Subject& subject, const structure::Report& report, const std::string& path,
                   bool json, const std::string& file_checksum = {}) {
  if (json) return {as_json(subject, report, path, file_checksum), kSuccess};
  return {fmt::format("{}: page written to {}\n", printable(subject.input), printable(path)),
          kSuccess};
}

/// A file name that every system takes: letters, digits and dashes of the line, after its number.
std::string file_stem(const topology::BatchLine& line) {
  std::string word;
  for (const char c : std::filesystem::path(line.text).stem().string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    word += plain ? c : '-';
    if (word.size() == 40) break;
  }
  return fmt::format("{:04}-{}", line.line_number, word);
}

/// The entries of a gallery in the making, by many threads.
class Gallery {
 public:
  /// Throws what OutputFile does for an index that cannot be written.
  explicit Gallery(const PageRequest& request)
      : request_(request),
        folder_(std::filesystem::path(request.path).parent_path()),
        index_(request.path) {}

  /// Takes a line with its page over from an earlier run; says what is wrong with it.
  std::string take(const topology::BatchLine& line, std::string_view answer) {
    try {
      return take(line, nlohmann::json::parse(answer));
    } catch (const nlohmann::json::exception&) {
      return "is no answer of a gallery";
    }
  }
  /// Throws what keeps the line from having a page, after it is noted for the index.
  Reply add(const topology::BatchLine& line) {
    viewer::GalleryEntry entry = entry_of(line);
    try {
      Reply outcome = make(line, entry);
      keep(entry);
      return outcome;
    } catch (const std::exception& error) {
      entry.problem = error.what();
      keep(entry);
      throw;
    }
  }

  void write_index(const std::string& title) {
    std::ranges::sort(entries_, {}, &viewer::GalleryEntry::line);
    index_.open() << viewer::gallery_html(title, entries_);
    index_.close();
  }

 private:
  std::string take(const topology::BatchLine& line, const nlohmann::json& found) {
    viewer::GalleryEntry entry = entry_of(line);
    if (found.contains("file")) {
      set_files(line, entry);
      if (found["file"] != path_of(entry.page))
        return "is of another index: its page is " + quoted(found.value("file", ""));
      for (const std::string& name : {entry.page, entry.picture})
        if (!std::filesystem::exists(path_of(name)))
          return "is of a page that is gone, " + quoted(path_of(name));
      if (found.contains("file_checksum") && found["file_checksum"] != checksum_of(entry))
        return "is of a page that was changed, " + quoted(path_of(entry.page));
      entry.name = found.value("name", line.text);
      entry.tetrahedron_count = found.value("tetrahedron_count", std::size_t{0});
      entry.volume = found.value("volume", 0.0);
      entry.boundary = found.value("boundary", "");
    } else {
      entry.problem = found.contains("error") ? found["error"].value("message", "")
                                              : found.value("message", "");
    }
    keep(entry);
    return {};
  }

  Reply make(const topology::BatchLine& line, viewer::GalleryEntry& entry) {
    if (line.text == "-") throw InvalidInput(kNoStandardInput);
    const Solved solved = find_metric(
        load_ideal_subject(line.text, Balls::kRefused, interruptible(), require_with_remedy), {},
        request_.search);
    const Subject& subject = solved.subject;
    const structure::Report& report = solved.report;
    if (!solved.is_geometric()) {
      entry.problem = report.message;
      return {request_.json ? report_as_json(subject, report, solved.search())
                            : report_as_text(subject, report, solved.search()),
              kNoAnswer};
    }
    const auto embedding =
        embedding::embed(subject.triangulation, report.edge_lengths, {subject.cone_angles, 0});
    entry.name = name_of(subject);
    set_files(line, entry);
    entry.tetrahedron_count = subject.triangulation.tetrahedron_count();
    entry.volume = report.volume;
    entry.boundary = boundary_of(report);
    const std::string path = path_of(entry.page);
    write_file(path, page_of(subject, report, embedding, request_,
                             std::filesystem::path(request_.path).filename().string()));
    viewer::write_png(viewer::inside_picture(embedding, subject.triangulation,
                                             viewer::kThumbnailWidth, viewer::kThumbnailHeight),
                      path_of(entry.picture));
    return page_written(subject, report, path, request_.json, checksum_of(entry));
  }

  /// Of the page and its picture together.
  std::string checksum_of(const viewer::GalleryEntry& entry) const {
    return checksum_text(read_file(path_of(entry.page)) + read_file(path_of(entry.picture)));
  }

  static viewer::GalleryEntry entry_of(const topology::BatchLine& line) {
    viewer::GalleryEntry entry;
    entry.line = line.line_number;
    entry.name = line.text;
    return entry;
  }
  static void set_files(const topology::BatchLine& line, viewer::GalleryEntry& entry) {
    entry.page = file_stem(line) + ".html";
    entry.picture = file_stem(line) + ".png";
  }
  std::string path_of(const std::string& name) const { return (folder_ / name).string(); }

  void keep(const viewer::GalleryEntry& entry) {
    const std::lock_guard lock(mutex_);
    entries_.push_back(entry);
  }

  const PageRequest& request_;
  const std::filesystem::path folder_;
  OutputFile index_;
  std::mutex mutex_;
  std::vector<viewer::GalleryEntry> entries_;
};

/// The index must not replace the list; nor anything, where there is no list.
/// Throws InvalidInput.
void check_list(const std::string& list) {
  require_not_written(list);
  if (list == "-") return;
  std::error_code unknown;
  // A pipe can be read only once.
  const bool is_pipe = std::filesystem::is_fifo(list, unknown);
  if (!is_pipe) (void)read_batch_file(list);
}

}  // namespace

std::shared_ptr<const viewer::WallDiscs> discs_for(const DiscRequest& request,
                                                   const Subject& subject,
                                                   const structure::Report& report,
                                                   const embedding::Embedding& embedding) {
  if (!request.wanted) return nullptr;
  if (std::ranges::none_of(report.vertices, [](const structure::VertexReport& vertex) {
        return vertex.kind == topology::VertexKind::kHyperideal;
      }))
    throw InvalidInput("--discs: there is no geodesic boundary to draw them on");
  try {
    return std::make_shared<const viewer::WallDiscs>(viewer::find_wall_discs(
        embedding, subject.triangulation, report.edge_lengths, request.length, interruptible()));
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format(
        "--discs{}: {}", request.length ? fmt::format(" {}", *request.length) : "", error.what()));
  }
}

void check_pages(const PageRequest& request) {
  if (request.path.empty())
    throw InvalidInput("--gallery: say with -o where the index page goes, such as -o index.html");
  if (request.cells > viewer::kMostPageCells) {
    throw InvalidInput(fmt::format("--cells {}: a page shows at most {} cells", request.cells,
                                   viewer::kMostPageCells));
  }
}

Reply write_page(const Subject& subject, const structure::Report& report,
                 const embedding::Embedding& embedding, const PageRequest& request) {
  check_pages(request);
  write_file(request.path, page_of(subject, report, embedding, request, ""));
  return page_written(subject, report, request.path, request.json);
}

int write_gallery(const CommonOptions& list, const PageRequest& request) {
  check_pages(request);
  declare_output("-o", request.path);
  check_list(list.batch);
  Gallery gallery(request);
  const std::string title =
      list.batch == "-" ? "Manifolds"
                        : "Manifolds of " + std::filesystem::path(list.batch).stem().string();
  const int status = answer_lines(
      list, [&](const topology::BatchLine& line) { return gallery.add(line); },
      [&](const topology::BatchLine& line, std::string_view answer) {
        return gallery.take(line, answer);
      });
  gallery.write_index(title);
  return status;
}

}  // namespace tripus::cli
