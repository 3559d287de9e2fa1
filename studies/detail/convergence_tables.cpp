#include "studies/detail/convergence_tables.hpp"

namespace tripus::studies::detail {

std::vector<TableLayout> convergence_layouts() {
  const Column input{"input", "", "the triangulation"},
      degree{"degree", "", "of the cover; 1: none"}, tetrahedra{"tetrahedra", "", "T"},
      edges{"edges", "", "edge classes E"};
  return {
      {"runs",
       "One run of a method from the start that all share: random lengths between 1/3 and 3. The "
       "methods in angles start from angles deep inside their polytope instead.",
       {input,
        degree,
        tetrahedra,
        edges,
        {"method", "", "as after --method"},
        {"outcome", "", "what the run by itself ended with"},
        {"iterations", "", "steps"},
        {"evaluations", "", "of the gradient"},
        {"linear_iterations", "", "conjugate-gradient steps"},
        {"max_curvature", "radians", "max|K| at the end"},
        {"volume", "", "at the end"},
        {"order", "", "log(e2/e1) / log(e1/e0) of the last three max|K| above rounding"},
        {"evaluations_per_digit", "", "evaluations a decimal digit of max|K|"},
        {"squares_decrease", "", "whether sum K^2 decreased from iterate to iterate"},
        {"iterations_to_1e_4", "", "steps to max|K| <= 1e-4; empty: not reached"},
        {"iterations_to_1e_8", "", "steps to max|K| <= 1e-8"},
        {"iterations_to_1e_12", "", "steps to max|K| <= 1e-12"},
        {"seconds_to_1e_4", "seconds", "time to max|K| <= 1e-4", true},
        {"seconds_to_1e_8", "seconds", "time to max|K| <= 1e-8", true},
        {"seconds_to_1e_12", "seconds", "time to max|K| <= 1e-12", true},
        {"seconds_per_digit", "seconds", "time a decimal digit of max|K|", true},
        {"seconds", "seconds", "of the whole run", true}}},
      {"iterations",
       "One iterate of a run on the first input, its covers and up to 20 other inputs: every one "
       "up "
       "to the 100th, then those 2 % apart.",
       {input,
        {"method", "", "as after --method"},
        {"iteration", "", "0 is the start"},
        {"evaluations", "", "of the gradient so far"},
        {"max_curvature", "radians", "max|K|"},
        {"sum_squared_curvature", "radians^2", "sum K^2"},
        {"energy", "", "the co-volume functional H"},
        {"volume", "", "sum over the tetrahedra"},
        {"time", "", "flow time t; 0 for minimisers"},
        {"seconds", "seconds", "since the start of the run", true}}},
      {"theory",
       "What theory says about a triangulation, measured at its metric.",
       {input,
        degree,
        tetrahedra,
        edges,
        {"outcome", "", "of Newton's method"},
        {"lambda_min", "", "least eigenvalue of the Hessian of H, by Lanczos iterations"},
        {"lambda_max", "", "greatest eigenvalue, the same"},
        {"newton_order", "", "slope of log error after a step on log error before it"},
        {"euler_limit", "", "longest stable Euler step, by bisection"},
        {"euler_ratio", "", "euler_limit / (2 / lambda_max)"},
        {"decay_rate", "", "of |K| along dx/dt = K near the metric"},
        {"decay_ratio", "", "decay_rate / lambda_min"},
        {"squares_decrease", "", "whether sum K^2 decreased all along that flow"},
        {"volume_error", "", "volume / (degree x volume of the base) - 1"}}},
  };
}

}  // namespace tripus::studies::detail
