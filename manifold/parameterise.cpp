#include "manifold/parameterise.hpp"

#include <utility>

#include "base/stop.hpp"
#include "manifold/json_text.hpp"
#include "manifold/load.hpp"
#include "parameterise/picture.hpp"
#include "parameterise/refine.hpp"
#include "parameterise/vtu.hpp"

namespace tripus {

/// Of the tetrahedra of a refined mesh, to those with which a surface is filled first.
constexpr std::size_t kBisected = 4;

Parameterisation::Parameterisation(meshing::MeshFile file, std::string label,
                                   const ParameteriseOptions& options, const Context& context)
    : label_(std::move(label)), weights_(options.weights) {
  parameterise::require_refinable(options.refine);
  parameterise::MarkOptions marking = options.marking;
  // Bisection mends no mesh without points inside, so it is not left the most of the work.
  if (marking.tetrahedralize.tetrahedra == 0)
    marking.tetrahedralize.tetrahedra = options.refine / kBisected;
  solid_ = parameterise::mark_solid(std::move(file), marking, context);
  if (context.stop_requested()) throw Stopped();
  map_ = parameterise::refined_map(*solid_, options.weights, options.refine, options.map, context);
  const auto weights = parameterise::weighted_edges(*solid_, options.weights);
  edge_count_ = weights.edges.size();
  clipped_ = weights.clipped;
  relator_defect_ = parameterise::relator_defect(*solid_);
  equivariance_defect_ = parameterise::equivariance_defect(*solid_);
  quality_ = parameterise::quality(*solid_, map_.points);
}

std::string Parameterisation::advice() const {
  if (map_.termination != solver::Termination::kStalled &&
      map_.termination != solver::Termination::kUnbounded)
    return {};
  if (weights_ == parameterise::Weights::kFiniteElements)
    return "a larger tolerance; or, as some of these weights are negative where tetrahedra are "
           "flat, another mesh, a refined one, or the weights cotangent";
  return "a larger tolerance";
}

std::string Parameterisation::to_vtu() const {
  return parameterise::write_vtu(*solid_, map_, quality_);
}

std::string Parameterisation::to_page() const {
  return parameterise::report_page(label_, *solid_, map_, quality_);
}

std::string Parameterisation::to_svg(double cut_away) const {
  return parameterise::solid_picture(parameterise::coloured(*solid_, map_.points),
                                     {.cut_away = cut_away});
}

std::string Parameterisation::to_json() const {
  JsonText out;
  append_header(out, label_);
  const auto number = [&](std::string_view name, double value) {
    append(out, fmt::format(", \"{}\": ", name));
    append_number(out, value);
  };
  const auto count = [&](std::string_view name, std::size_t value) {
    append(out, fmt::format(", \"{}\": {}", name, value));
  };
  count("tetrahedra", solid_->mesh.tetrahedra.size());
  count("points", solid_->mesh.points.size());
  count("edges", edge_count_);
  append(out, ", \"boundary_genera\": ");
  append_array(out, solid_->boundary_genera,
               [](JsonText& to, int genus) { append(to, std::to_string(genus)); });
  count("manifold_tetrahedra", solid_->manifold->tetrahedron_count());
  number("manifold_volume", quality_.manifold_volume);
  count("simplification_steps", solid_->steps);
  count("deck_transformations", solid_->group->size());
  number("relator_defect", relator_defect_);
  number("equivariance_defect", equivariance_defect_);
  count("clipped_weights", clipped_);
  append(out, ", \"termination\": ");
  append_string(out, solver::to_string(map_.termination));
  number("energy", map_.energy);
  number("max_gradient", map_.max_gradient);
  count("iterations", static_cast<std::size_t>(map_.iterations));
  count("linear_iterations", static_cast<std::size_t>(map_.linear_iterations));
  number("seconds", map_.seconds);
  number("image_volume", quality_.image_volume);
  number("filled_volume", quality_.filled_volume);
  count("inverted", quality_.inverted);
  count("flat", quality_.flat);
  number("median_anisotropy", quality_.median_anisotropy);
  number("off_boundary", quality_.off_boundary);
  append(out, ", \"notes\": ");
  append_array(out, solid_->notes,
               [](JsonText& to, const std::string& note) { append_string(to, note); });
  out.push_back('}');
  return fmt::to_string(out);
}

Parameterisation parameterise_solid(const std::string& input, const ParameteriseOptions& options,
                                    const Context& context) {
  meshing::MeshFile file = load_mesh(input);
  const std::string source = input == "-" ? "standard input" : quoted(input);
  try {
    return {std::move(file), input, options, context};
  } catch (const Unsupported& error) {
    throw Unsupported(source + ": " + error.what());
  } catch (const InvalidInput& error) {
    throw InvalidInput(source + ": " + error.what());
  }
}

}  // namespace tripus
