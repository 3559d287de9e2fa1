#pragma once

#include <string>

#include "manifold/embedding_json.hpp"

namespace tripus::cli {

/// A few lines for people; `output` is the file written.
std::string embedding_as_text(const EmbeddedSubject& embedded, const std::string& output);

}  // namespace tripus::cli
