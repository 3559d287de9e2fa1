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

}  // namespace tripus::structure
