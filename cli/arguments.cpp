#include "cli/arguments.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "topology/isosig.hpp"

namespace tripus::cli {
namespace {

/// 63 tetrahedra take more characters than this, and no option has a name or a value like it.
constexpr std::size_t kLongestOption = 64;

bool is_shielded(const std::string& text) {
  return text.size() > kLongestOption && text.starts_with(" -");
}

}  // namespace

std::vector<std::string> shield_signatures(std::vector<std::string> arguments) {
  for (std::string& argument : arguments) {
    if (argument.size() > kLongestOption && argument.front() == '-' &&
        topology::looks_like_isosig(argument))
      argument.insert(0, " ");
  }
  return arguments;
}

CLI::Validator unshield() {
  return {[](std::string& text) {
            if (is_shielded(text)) text.erase(0, 1);
            return std::string();
          },
          ""};
}

CLI::Validator file_name(std::vector<std::string> endings) {
  return {[endings = std::move(endings)](std::string& text) -> std::string {
            std::string ending = std::filesystem::path(text).extension().string();
            for (char& c : ending)
              c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            if (std::ranges::find(endings, ending) != endings.end()) return {};
            return fmt::format("the name {} must end with {}", tripus::quoted(text),
                               fmt::join(endings, " or "));
          },
          ""};
}

std::string problem_of_name(const std::string& name) {
  return name.empty() ? "the name of the file is empty" : "";
}

}  // namespace tripus::cli
