#include "base/compression.hpp"
#include "base/error.hpp"
#include "cli/census.hpp"
#include "manifold/load.hpp"

namespace tripus::cli {
namespace {

/// What a compressed table may hold at most.
constexpr std::size_t kMostBytes = std::size_t{4} << 30;

}  // namespace

ChosenCensus::ChosenCensus(const std::string& path) {
  if (path.empty()) return;
  std::string text = read_file(path);
  if (text.starts_with("SQLite format 3")) {  // files begin with the name of their format
    loaded_ = canonical::read_database(path);
    return;
  }
  try {
    if (is_gzip(text)) text = gunzip(text, kMostBytes);
    loaded_ = canonical::parse_tsv(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput(tripus::quoted(path) + ": " + error.what());
  }
}

}  // namespace tripus::cli
