#include "structure/report.hpp"

namespace tripus::structure {

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::kGeometric:
      return "geometric";
    case Outcome::kDegenerate:
      return "degenerate";
    case Outcome::kInfeasible:
      return "infeasible";
    case Outcome::kUnresolved:
      return "unresolved";
  }
  return "unresolved";
}

std::string_view to_string(Advice advice) {
  switch (advice) {
    case Advice::kNone:
      return "none";
    case Advice::kRetriangulate:
      return "retriangulate";
    case Advice::kMoreTime:
      return "more time";
    case Advice::kLooserTolerance:
      return "looser tolerance";
    case Advice::kLargerSearch:
      return "larger search";
    case Advice::kMoreSearchTime:
      return "more search time";
    case Advice::kLargerTriangulation:
      return "larger triangulation";
  }
  return "none";
}

}  // namespace tripus::structure
