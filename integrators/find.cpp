#include <algorithm>

#include "integrators/flow.hpp"
#include "integrators/stepper.hpp"

namespace tripus::integrators {
namespace {

template <class Row>
const Row* find(std::span<const Row> rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

const Flow* find_flow(std::string_view name) { return find(flows(), name); }
const Stepper* find_stepper(std::string_view name) { return find(steppers(), name); }

}  // namespace tripus::integrators
