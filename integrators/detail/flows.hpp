#pragma once

#include <memory>

#include "integrators/flow.hpp"

/// The flows, one a source file in integrators/flows; integrators/flows.cpp lists them.
namespace tripus::integrators::detail {

std::unique_ptr<Field> make_curvature(solver::Problem& problem);
std::unique_ptr<Field> make_scaled(solver::Problem& problem);
std::unique_ptr<Field> make_newton_flow(solver::Problem& problem);
std::unique_ptr<Field> make_calabi(solver::Problem& problem);

}  // namespace tripus::integrators::detail
