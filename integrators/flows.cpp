#include "integrators/detail/flows.hpp"

namespace tripus::integrators {
namespace {

constexpr Flow kFlows[] = {
    {"curvature", "dx/dt = -g: gradient flow", detail::make_curvature},
    {"scaled", "dx/dt = -g x, component by component: keeps x positive", detail::make_scaled},
    {"newton-flow", "dx/dt = -H^-1 g: the gradient decays like e^-t", detail::make_newton_flow},
    {"calabi", "dx/dt = -H g: gradient flow of |g|^2 / 2", detail::make_calabi},
};

}  // namespace

std::span<const Flow> flows() { return kFlows; }

const Flow* find_flow(std::string_view name) {
  for (const Flow& flow : kFlows) {
    if (flow.name == name) return &flow;
  }
  return nullptr;
}

}  // namespace tripus::integrators
