#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/error.hpp"

namespace tripus {

/// The rows of a table that several source files share (cmake/TripusRegistry.cmake), by their
/// `place`, and by name where that is the same. Throws InternalError if two have one name.
template <class Row>
std::vector<Row> in_order(std::initializer_list<std::span<const Row>> files) {
  std::vector<Row> rows;
  for (const auto& file : files) rows.insert(rows.end(), file.begin(), file.end());
  std::ranges::sort(rows, [](const Row& a, const Row& b) {
    return std::tie(a.place, a.name) < std::tie(b.place, b.name);
  });
  for (auto row = rows.begin(); row != rows.end(); ++row)
    if (std::any_of(rows.begin(), row, [&](const Row& other) { return other.name == row->name; }))
      throw InternalError("two entries of a table are called " + std::string(row->name));
  return rows;
}

/// The row of that name, or null.
template <class Row>
const Row* find_row(std::span<const Row> rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  return found == rows.end() ? nullptr : &*found;
}

/// The place of rows that do not ask for one.
inline constexpr int kAnyPlace = 100;

}  // namespace tripus
