#include "structure/method.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "integrators/integrate.hpp"

namespace tripus::structure {
namespace {

/// Above so many edge classes the factors of the Hessian fill in, and conjugate gradients win.
constexpr std::size_t kDirectLimit = 1000;

}  // namespace

SolveMethod find_solve_method(std::string_view name, std::size_t edge_count) {
  if (name == "auto") name = edge_count <= kDirectLimit ? "newton" : "newton-cg";
  SolveMethod method;
  method.name = name;
  if (const auto flow = integrators::parse_flow_method(name)) {
    method.energy = energies::energy_in_lengths();
    method.flow = flow->first;
    method.stepper = flow->second;
    return method;
  }
  for (const energies::Energy& energy : energies::energies()) {
    if (!name.starts_with(energy.prefix)) continue;
    const auto* minimiser = solver::find_method(name.substr(energy.prefix.size()));
    if (minimiser == nullptr) continue;
    method.energy = &energy;
    method.minimiser = minimiser;
  }
  if (method.minimiser == nullptr) {
    throw InvalidInput(fmt::format("there is no method {}; the methods are auto, {}",
                                   quoted(std::string(name)),
                                   fmt::join(solve_method_names(), ", ")));
  }
  return method;
}

solver::Summary run(const SolveMethod& method, energies::Functional& functional,
                    std::span<double> x, const solver::Options& options) {
  return method.flow != nullptr ? integrators::integrate(functional.problem(), *method.flow,
                                                         *method.stepper, x, options)
                                : method.minimiser->minimise(functional.problem(), x, options);
}

std::vector<std::string> solve_method_names() {
  std::vector<std::string> names;
  for (const auto& energy : energies::energies())
    for (const auto& method : solver::methods())
      names.push_back(fmt::format("{}{}", energy.prefix, method.name));
  for (const auto& flow : integrators::flows())
    for (const auto& stepper : integrators::steppers())
      names.push_back(fmt::format("flow:{}/{}", flow.name, stepper.name));
  return names;
}

}  // namespace tripus::structure
