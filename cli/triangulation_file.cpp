#include "cli/triangulation_file.hpp"

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "topology/formats/json.hpp"

namespace tripus::cli {

void require_triangulation_name(const std::string& path) {
  if (!path.ends_with(".json") && !path.ends_with(".sig"))
    throw InvalidInput("-o " + quoted(path) +
                       ": the name must end with .json (gluing table) or .sig (signature)");
}

void write_triangulation_file(const std::string& path, const std::string& name,
                              const topology::Gluings& gluings,
                              const std::optional<std::string>& isosig) {
  require_triangulation_name(path);
  if (path.ends_with(".sig") && !isosig)
    throw InvalidInput("the signature would take too long to compute; write .json");
  const std::string text =
      path.ends_with(".sig") ? *isosig + "\n" : topology::write_json({name, gluings});
  write_file(path, text);
}

}  // namespace tripus::cli
