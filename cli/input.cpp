#include "cli/input.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <vector>

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

/// Enough for ten million tetrahedra in any format; some files, such as /dev/zero, have no end.
constexpr std::size_t kLargestInput = std::size_t{1} << 30;

std::string read_all(std::istream& in, const std::string& source) {
  std::string content;
  std::vector<char> block(1 << 16);
  while (in.read(block.data(), std::ptrdiff_t(block.size())) || in.gcount() > 0) {
    content.append(block.data(), std::size_t(in.gcount()));
    if (content.size() > kLargestInput) throw InvalidInput(source + " is longer than 1 GiB");
  }
  if (in.bad()) throw InvalidInput("cannot read " + source + ": " + std::strerror(errno));
  return content;
}

}  // namespace

std::string read_file(const std::string& path) {
  if (path == "-") return read_all(std::cin, "standard input");
  std::error_code status;
  if (std::filesystem::is_directory(path, status))
    throw InvalidInput(quoted(path) + " is a folder; name a file in it");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput("cannot open " + quoted(path) + ": " + std::strerror(errno));
  return read_all(file, quoted(path));
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
