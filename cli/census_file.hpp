#pragma once

#include <optional>
#include <string>

#include "canonical/census.hpp"

namespace tripus::cli {

/// The census of a file, TSV (also compressed by gzip) or SQLite, recognised by its content; the
/// shipped one if the name is empty. Throws InvalidInput, naming the file.
class ChosenCensus {
 public:
  explicit ChosenCensus(const std::string& path);
  const canonical::Census& get() const { return loaded_ ? *loaded_ : canonical::shipped_census(); }

 private:
  std::optional<canonical::Census> loaded_;
};

}  // namespace tripus::cli
