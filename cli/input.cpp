#include "cli/input.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "base/error.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {
namespace {

/// The one triangulation in a text; a list of several belongs to --batch.
topology::NamedGluings read_single(const std::string& text, const std::string& source) {
  try {
    const topology::TextFormat format = topology::detect_format(text);
    if (format != topology::TextFormat::kUnknown && format != topology::TextFormat::kIsosig)
      return topology::read_triangulation(text);
    const auto lines = topology::read_batch(text);
    if (lines.size() == 1 && topology::looks_like_isosig(lines.front().text))
      return topology::read_triangulation(lines.front().text);
    if (lines.size() > 1 && topology::looks_like_isosig(lines.front().text)) {
      throw InvalidInput("it holds " + std::to_string(lines.size()) +
                         " inputs; give it to --batch to run them all");
    }
    return topology::read_triangulation(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
}

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") {
    return {std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  }
  std::error_code status;
  if (std::filesystem::is_directory(path, status))
    throw InvalidInput(quoted(path) + " is a folder; name a file in it");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InvalidInput("cannot open " + quoted(path) + ": " + std::strerror(errno));
  }
  std::ostringstream content;
  content << file.rdbuf();
  if (file.bad()) throw InvalidInput("cannot read " + quoted(path) + ": " + std::strerror(errno));
  return std::move(content).str();
}

topology::NamedGluings load_input(const std::string& input) {
  if (input.empty()) throw InvalidInput("the input is empty; give a signature or a file");
  if (input == "-") return read_single(read_file(input), "standard input");
  std::error_code status;
  if (std::filesystem::exists(input, status)) return read_single(read_file(input), quoted(input));
  if (topology::looks_like_isosig(input)) return {{}, topology::decode_isosig(input)};
  throw InvalidInput(quoted(input) +
                     " is neither a file nor an isomorphism signature (letters, digits, + and -)");
}

}  // namespace tripus::cli
