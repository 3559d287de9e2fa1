#include <fmt/format.h>

#include "cli/files.hpp"

namespace tripus::cli {

HistoryFile::HistoryFile(const std::string& path) : file_(path), out_(file_.open()) {
  out_ << "iteration,evaluations,seconds,max_curvature,energy,volume,shortest_edge,longest_edge\n";
}

void HistoryFile::add(const structure::HistoryRow& row) {
  // A failure is kept by the stream until `close` reports it.
  out_ << fmt::format("{},{},{},{},{},{},{},{}\n", row.iteration, row.evaluations, row.seconds,
                      row.max_curvature, row.energy, row.volume, row.shortest_edge,
                      row.longest_edge);
  if (file_.is_direct()) out_.flush();
}

}  // namespace tripus::cli
