#pragma once

#include <cctype>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "energies/energies.hpp"
#include "integrators/flow.hpp"
#include "integrators/stepper.hpp"
#include "solver/method.hpp"

// How GoogleTest prints the lines of the tables that tests run over: by name. Each function lies in
// the namespace of its type, where the lookup by arguments finds it.

namespace tripus::energies {
inline void PrintTo(const Energy& energy, std::ostream* out) { *out << energy.name; }
}  // namespace tripus::energies

namespace tripus::solver {
inline void PrintTo(const Method& method, std::ostream* out) { *out << method.name; }
}  // namespace tripus::solver

namespace tripus::integrators {
inline void PrintTo(const Flow& flow, std::ostream* out) { *out << flow.name; }
inline void PrintTo(const Stepper& stepper, std::ostream* out) { *out << stepper.name; }
}  // namespace tripus::integrators

namespace tripus::testing {

/// A name that GoogleTest takes: letters, digits and underscores.
inline std::string test_name(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

/// A flow with a stepper, as after --method flow:
using FlowAndStepper = std::tuple<integrators::Flow, integrators::Stepper>;

inline std::string test_name(const FlowAndStepper& both) {
  return test_name(std::string(std::get<0>(both).name) + "_" + std::string(std::get<1>(both).name));
}

/// Every flow but those named, with every stepper.
inline std::vector<FlowAndStepper> flows_but(const std::vector<std::string_view>& without) {
  std::vector<FlowAndStepper> all;
  for (const integrators::Flow& flow : integrators::flows()) {
    bool wanted = true;
    for (const std::string_view name : without) wanted = wanted && flow.name != name;
    if (!wanted) continue;
    for (const integrators::Stepper& stepper : integrators::steppers())
      all.emplace_back(flow, stepper);
  }
  return all;
}

}  // namespace tripus::testing
