#include <array>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "cli/files.hpp"
#include "cli/output.hpp"
#include "topology/formats/formats.hpp"

namespace tripus::cli {

namespace {

struct Ending {
  std::string_view ending;
  std::string (*write)(const topology::NamedGluings&);  ///< null: the signature
};

/// A new format is one line here.
constexpr std::array kEndings{Ending{".json", topology::write_json}, Ending{".sig", nullptr},
                              Ending{".rga", topology::write_regina_xml},
                              Ending{".tri", topology::write_snappea}};

const Ending* find_ending(const std::string& path) {
  for (const Ending& each : kEndings)
    if (path.ends_with(each.ending)) return &each;
  return nullptr;
}

}  // namespace

void require_triangulation_name(const std::string& path) {
  if (!find_ending(path))
    throw InvalidInput("-o " + quoted(path) +
                       ": the name must end with .json (gluing table), .sig (signature), .rga "
                       "(Regina) or .tri (SnapPea)");
}

void require_format_for(const std::string& path, std::span<const topology::ConeAngle> cone_angles) {
  if (!topology::all_full(cone_angles) && !path.ends_with(".json"))
    throw InvalidInput("-o " + quoted(path) +
                       ": this format keeps no cone angles; .json (gluing table) does");
}

void write_triangulation_file(const std::string& path, const Subject& subject) {
  require_triangulation_name(path);
  require_format_for(path, subject.cone_angles);
  const Ending& ending = *find_ending(path);
  const auto& isosig = subject.best_signature();
  if (!ending.write && !isosig)
    throw InvalidInput("the signature would take too long to compute; write .json");
  write_file(path, ending.write ? ending.write({.name = subject.name,
                                                .gluings = subject.triangulation.gluings(),
                                                .cone_angles = subject.cone_angles})
                                : *isosig + "\n");
  if (ending.write || subject.orientation_known || !subject.triangulation.is_orientable()) return;
  write_message(
      fmt::format("tripus: note: {} tells no orientation, since INPUT tells none (a signature with "
                  "+ or - does)\n",
                  tripus::quoted(path)));
}

}  // namespace tripus::cli
