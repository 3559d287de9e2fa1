// tripus page: the page that computes and draws in a browser, as a file.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "base/output_file.hpp"
#include "cli/arguments.hpp"
#include "cli/describe.hpp"
#include "cli/failure.hpp"
#include "cli/output.hpp"
#include "cli/verb.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"

namespace tripus::cli {
namespace {

constexpr const char* kPageHelp =
    "One file of some megabytes that needs no network and no installation: open it in a browser,\n"
    "put it on a server, send it to a colleague. It reads signatures, names, diagrams, gluing\n"
    "tables and dropped files, solves them, and draws the universal cover and the view from\n"
    "inside. It sends nothing anywhere. `tripus view INPUT -o FILE.html` writes a page of one\n"
    "manifold, which is smaller.\n"
    "\n"
    "The page is made by scripts/page, and found beside the program or where it was installed; "
    "the\n"
    "environment variable TRIPUS_PAGE may name it. docs/browser.md says more.\n"
    "\n"
    "Example:\n"
    "  tripus page -o tripus.html\n"
    "\n"
    "Exit status: 0 written, 2 bad usage, 3 a failure of the program itself.";

/// What the page says of itself (web/page/page.html).
constexpr std::string_view kMark = "<meta name=\"generator\" content=\"tripus ";

struct PageCommand {
  std::string output;
  bool json = false;
};

/// The page that scripts/page made.
std::string find_page() {
  namespace fs = std::filesystem;
  if (const char* named = std::getenv("TRIPUS_PAGE"); named != nullptr && *named != '\0') {
    std::error_code status;
    if (fs::is_regular_file(named, status)) return named;
    throw Unsupported("the environment variable TRIPUS_PAGE names " + quoted(named, 200) +
                      ", which is no file");
  }
  std::error_code status;
  const fs::path folder = fs::read_symlink("/proc/self/exe", status).parent_path();
  // Installed, beside the program, and in the folder of a build, build/release/bin.
  const std::array<fs::path, 3> places = {
      folder.parent_path() / "share" / "tripus" / "tripus.html", folder / "tripus.html",
      folder.parent_path().parent_path() / "page" / "tripus.html"};
  for (const fs::path& place : places)
    if (fs::is_regular_file(place, status)) return place.string();
  throw Unsupported(
      "this program was built without the page for browsers: run scripts/page in the sources of "
      "Tripus, which makes build/page/tripus.html, and install again, or name that file in the "
      "environment variable TRIPUS_PAGE. `tripus view INPUT -o FILE.html` writes a page of one "
      "manifold without it");
}

int run(const PageCommand& command) {
  declare_output("-o", command.output);
  const std::string page = find_page();
  const std::string text = read_file(page);
  if (text.find(kMark) == std::string::npos)
    throw Unsupported(quoted(page, 200) + " is not the page that scripts/page makes");
  write_file(command.output, text);
  if (command.json) {
    JsonText out;
    append_header(out, "page");
    append(out, fmt::format(", \"bytes\": {}, \"file\": ", text.size()));
    append_string(out, command.output);
    append(out, "}\n");
    write_output({out.data(), out.size()});
  } else {
    write_output(fmt::format("the page, {:.1f} MB, was written to {}: open it in a browser\n",
                             static_cast<double>(text.size()) / 1e6, printable(command.output)));
  }
  return kSuccess;
}

void add_page(CLI::App* verb, Command& chosen) {
  auto command = std::make_shared<PageCommand>();
  verb->add_option("-o,--output", command->output, "file to write")
      ->option_text("FILE.html")
      ->check(file_name({".html", ".htm"}))
      ->required();
  verb->add_flag("--json", command->json, "one JSON object on standard output");
  verb->footer(kPageHelp);
  verb->final_callback([command, &chosen] { chosen = [command] { return run(*command); }; });
}

}  // namespace

namespace registered_verbs {

std::span<const Verb> page() {
  static constexpr Verb kRows[] = {
      {"page", "the page that computes and draws in a browser, as a file", add_page, 22}};
  return kRows;
}

}  // namespace registered_verbs
}  // namespace tripus::cli
