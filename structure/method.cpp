#include "structure/method.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "integrators/integrate.hpp"

namespace tripus::structure {
namespace {

constexpr std::string_view kAnglesPrefix = "angles:";

/// Above so many edge classes the factors of the Hessian fill in, and conjugate gradients win.
constexpr std::size_t kDirectLimit = 1000;

}  // namespace

SolveMethod find_solve_method(std::string_view name, std::size_t edge_count) {
  if (name == "auto") name = edge_count <= kDirectLimit ? "newton" : "newton-cg";
  SolveMethod method;
  method.name = name;
  if (const auto flow = integrators::parse_flow_method(name)) {
    method.form = SolveMethod::Form::kFlow;
    method.flow = flow->first;
    method.stepper = flow->second;
    return method;
  }
  if (name.starts_with(kAnglesPrefix)) {
    method.form = SolveMethod::Form::kAngles;
    method.minimiser = solver::find_method(name.substr(kAnglesPrefix.size()));
  } else {
    method.minimiser = solver::find_method(name);
  }
  if (method.minimiser == nullptr) {
    throw InvalidInput(fmt::format("there is no method {}; the methods are auto, {}",
                                   quoted(std::string(name)),
                                   fmt::join(solve_method_names(), ", ")));
  }
  return method;
}

std::vector<std::string> solve_method_names() {
  std::vector<std::string> names;
  for (const auto& method : solver::methods()) names.emplace_back(method.name);
  for (const auto& method : solver::methods())
    names.push_back(fmt::format("{}{}", kAnglesPrefix, method.name));
  for (const auto& flow : integrators::flows())
    for (const auto& stepper : integrators::steppers())
      names.push_back(fmt::format("flow:{}/{}", flow.name, stepper.name));
  return names;
}

}  // namespace tripus::structure
