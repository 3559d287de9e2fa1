#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.hpp"
#include "studies/detail/tables.hpp"
#include "studies/study.hpp"

namespace tripus::studies {
namespace {

constexpr Study kStudies[] = {
    {"convergence", "Convergence: Newton's method, first-order methods and flows from one start",
     "every method and flow from the same start, and on covers of growing size", 20,
     "inputs besides the first, chosen at random", detail::plan_convergence},
    {"stability", "Stability: which starting lengths converge",
     "which starting lengths converge, by the paper's formulae and by Tripus", 200,
     "random starts an input", detail::plan_stability},
    {"paper", "The paper's experiment: errors against an independent algebraic route",
     "the paper's flow on many manifolds, against gluing equations solved in 60 digits", 200,
     "inputs, chosen at random", detail::plan_paper},
    {"triangulations", "Triangulations: many of one manifold",
     "many triangulations of one manifold: which carry the metric, and how well", 1000,
     "distinct triangulations an input", detail::plan_triangulations},
    {"valence", "Valences of 6 and more: proved to carry the metric",
     "edge classes of high valence only: a proof of the metric for each", 6,
     "least valence of an edge class", detail::plan_valence},
};

}  // namespace

std::span<const Study> studies() { return kStudies; }

const Study& find_study(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Study& study : kStudies) {
    if (study.name == name) return study;
    names.push_back(study.name);
  }
  throw InvalidInput(fmt::format("there is no study {}; the studies are {}",
                                 tripus::quoted(std::string(name)), fmt::join(names, ", ")));
}

}  // namespace tripus::studies
