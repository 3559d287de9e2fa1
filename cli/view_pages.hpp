#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "cli/answer.hpp"
#include "cli/describe.hpp"
#include "cli/metric.hpp"
#include "embedding/embedding.hpp"
#include "structure/report.hpp"
#include "viewer/wall_discs.hpp"

namespace tripus::cli {

/// --discs: whether discs are drawn on the truncations, and up to which length of arcs.
struct DiscRequest {
  bool wanted = false;
  std::optional<double> length;
};

/// The discs that are asked for, or null. Throws InvalidInput in the words of the option.
std::shared_ptr<const viewer::WallDiscs> discs_for(const DiscRequest& request,
                                                   const Subject& subject,
                                                   const structure::Report& report,
                                                   const embedding::Embedding& embedding);

/// How a page for a browser opens, and where it goes.
struct PageRequest {
  std::string path;
  std::size_t cells = 20;
  std::string model = "ball";
  bool json = false;
  MetricSearch search = {};
  DiscRequest discs = {};
};

/// Throws InvalidInput, naming the option, where pages cannot do what was asked for.
void check_pages(const PageRequest& request);

/// Writes the page of one manifold. Throws InvalidInput if it cannot be written.
Reply write_page(const Subject& subject, const structure::Report& report,
                 const embedding::Embedding& embedding, const PageRequest& request);

/// Writes a page and a thumbnail for each line of a list beside the index `request.path`, and the
/// index last. A line that gives no page is named in the index with the reason, and on standard
/// error; the rest goes on. Returns the exit status of a batch.
/// Throws InvalidInput if the list cannot be read or the index cannot be written.
int write_gallery(const CommonOptions& list, const PageRequest& request);

}  // namespace tripus::cli
