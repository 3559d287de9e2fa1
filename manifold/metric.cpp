#include "manifold/metric.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "embedding/developing_map.hpp"
#include "embedding/export/mesh_formats.hpp"
#include "structure/proof/digits.hpp"

namespace tripus {
namespace {

/// The mesh format that the ending of a name asks for.
const embedding::CellFormat& mesh_format_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string known;
  for (const embedding::CellFormat& format : embedding::mesh_formats()) {
    if (ending.size() > 1 && ending.substr(1) == format.extension) return format;
    known += (known.empty() ? "." : ", .") + std::string(format.extension);
  }
  throw InvalidInput("cannot write cells to " + quoted(path) + ": the name must end with " + known);
}

}  // namespace

std::size_t CellComplex::write(const std::string& path, const CellFileOptions& options,
                               const Context& context) const {
  const embedding::CellFormat& format = mesh_format_of(path);
  OutputFile file(path);
  const embedding::Tessellation tessellation(*embedding_, cover_.cells,
                                             {options.model, options.error, context.stop});
  if (tessellation.triangle_count() > embedding::kMostTriangles)
    throw InvalidInput(std::to_string(tessellation.triangle_count()) +
                       " triangles are too many for a file; write fewer cells or allow a larger "
                       "error");
  const std::size_t written = format.write(file.open(), tessellation);
  file.close();
  return written;
}

std::shared_ptr<const embedding::Embedding> Metric::shared_embedding() const {
  std::call_once(placed_, [this] {
    embedding_ = std::make_shared<const embedding::Embedding>(embedding::embed(
        triangulation_, report_.edge_lengths, {{cone_angles_.begin(), cone_angles_.end()}, 0}));
  });
  return embedding_;
}

structure::Proof Metric::prove(const Context& context) const {
  structure::ProveOptions options;
  options.cone_angles.assign(cone_angles_.begin(), cone_angles_.end());
  return structure::prove_near(triangulation_, report_.edge_lengths, options, context);
}

embedding::Holonomy Metric::holonomy() const {
  return embedding::holonomy(embedding(), triangulation_);
}

CellComplex Metric::universal_cover(std::size_t cells, const Context& context) const {
  embedding::UniversalCoverOptions options;
  options.max_cells = cells;
  CellComplex complex = universal_cover(options, context);
  return complex;
}

CellComplex Metric::universal_cover(embedding::UniversalCoverOptions options,
                                    const Context& context) const {
  options.stop = context.stop;
  return {shared_embedding(),
          embedding::grow_universal_cover(embedding(), triangulation_, options)};
}

CellComplex Metric::fundamental_domain() const {
  return {shared_embedding(),
          {embedding::fundamental_domain(embedding(), triangulation_.gluings()), {}}};
}

}  // namespace tripus
