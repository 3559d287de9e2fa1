#include "energies/element_pattern.hpp"

#include <algorithm>

namespace tripus::energies {
namespace {

/// The elements that each variable occurs in, as compressed rows; an element stands once for each
/// of its occurrences.
struct Incidence {
  std::vector<std::size_t> start;
  std::vector<std::size_t> element;
};

Incidence incidence_of(std::size_t variable_count, std::size_t width,
                       std::span<const std::uint32_t> variables) {
  Incidence in;
  in.start.assign(variable_count + 1, 0);
  for (const std::uint32_t v : variables)
    if (v != kNoVariable) ++in.start[v + 1];
  for (std::size_t v = 0; v < variable_count; ++v) in.start[v + 1] += in.start[v];
  in.element.resize(in.start[variable_count]);
  std::vector<std::size_t> next(in.start.begin(), in.start.end() - 1);
  for (std::size_t k = 0; k < variables.size(); ++k)
    if (variables[k] != kNoVariable) in.element[next[variables[k]]++] = k / width;
  return in;
}

}  // namespace

ElementPattern::ElementPattern(std::size_t variable_count, std::size_t width,
                               std::span<const std::uint32_t> variables)
    : pairs_(width * (width + 1) / 2) {
  const std::size_t elements = variables.size() / width;
  slots_.assign(elements * pairs_, -1);
  pattern_.column_start.assign(1, 0);
  const Incidence in = incidence_of(variable_count, width, variables);

  // Column by column: collect the rows, sort them, then hand the position of each row to every
  // local pair of this column. `position` is valid for the rows of the current column only.
  std::vector<std::int64_t> position(variable_count, -1);
  std::vector<std::int32_t> rows;
  for (std::size_t column = 0; column < variable_count; ++column) {
    const auto touching =
        std::span(in.element).subspan(in.start[column], in.start[column + 1] - in.start[column]);
    rows.assign(1, static_cast<std::int32_t>(column));
    position[column] = 0;
    // An element that holds the variable more than once stands there as often, in a row.
    std::size_t previous = elements;
    for (const std::size_t element : touching) {
      if (element == previous) continue;
      previous = element;
      for (const std::uint32_t v : variables.subspan(element * width, width)) {
        if (v == kNoVariable || v < column || position[v] >= 0) continue;
        position[v] = 0;
        rows.push_back(static_cast<std::int32_t>(v));
      }
    }
    std::sort(rows.begin(), rows.end());
    const std::int64_t base = pattern_.column_start.back();
    for (std::size_t k = 0; k < rows.size(); ++k)
      position[static_cast<std::size_t>(rows[k])] = base + static_cast<std::int64_t>(k);
    previous = elements;
    for (const std::size_t element : touching) {
      if (element == previous) continue;
      previous = element;
      const auto local = variables.subspan(element * width, width);
      std::size_t q = 0;
      for (std::size_t i = 0; i < width; ++i) {
        for (std::size_t j = i; j < width; ++j, ++q) {
          if (local[i] == kNoVariable || local[j] == kNoVariable) continue;
          if (std::min(local[i], local[j]) == column)
            slots_[element * pairs_ + q] = position[std::max(local[i], local[j])];
        }
      }
    }
    for (const std::int32_t row : rows) position[static_cast<std::size_t>(row)] = -1;
    pattern_.row.insert(pattern_.row.end(), rows.begin(), rows.end());
    pattern_.column_start.push_back(static_cast<std::int64_t>(pattern_.row.size()));
  }
}

}  // namespace tripus::energies
