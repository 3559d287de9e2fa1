#include "cli/history_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus::cli {

HistoryFile::HistoryFile(const std::string& path)
    : path_(path), file_(std::fopen(path.c_str(), "w")) {
  if (file_ == nullptr)
    throw InvalidInput("cannot write the history to " + tripus::quoted(path) + ": " +
                       std::strerror(errno));
  std::setvbuf(file_, nullptr, _IOLBF, BUFSIZ);  // whoever watches a long run sees every row
  std::fputs(
      "iteration,evaluations,seconds,max_curvature,energy,volume,shortest_edge,longest_edge\n",
      file_);
}

HistoryFile::~HistoryFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void HistoryFile::add(const structure::HistoryRow& row) {
  // A failure is kept by the stream until `close` reports it.
  std::fputs(
      fmt::format("{},{},{},{},{},{},{},{}\n", row.iteration, row.evaluations, row.seconds,
                  row.max_curvature, row.energy, row.volume, row.shortest_edge, row.longest_edge)
          .c_str(),
      file_);
}

void HistoryFile::close() {
  const bool failed = std::ferror(file_) != 0;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (failed || !closed) throw Error("cannot write the history to " + tripus::quoted(path_));
}

}  // namespace tripus::cli
