#include "cli/census_file.hpp"

#include "base/error.hpp"
#include "manifold/load.hpp"

namespace tripus::cli {

ChosenCensus::ChosenCensus(const std::string& path) {
  if (path.empty()) return;
  const std::string text = read_file(path);
  if (text.starts_with("SQLite format 3")) {  // files begin with the name of their format
    loaded_ = canonical::read_database(path);
    return;
  }
  try {
    loaded_ = canonical::parse_tsv(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput(tripus::quoted(path) + ": " + error.what());
  }
}

}  // namespace tripus::cli
