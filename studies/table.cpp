#include "studies/table.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "base/error.hpp"

namespace tripus::studies {
namespace {

void append_field(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

}  // namespace

std::string cell(double value) {
  if (!std::isfinite(value)) return {};
  return fmt::format("{}", value == 0 ? 0.0 : value);
}

void Table::add(std::vector<std::string> row) {
  if (row.size() != layout_.columns.size()) {
    throw InternalError(fmt::format("a row of {} cells for the {} columns of table {}", row.size(),
                                    layout_.columns.size(), layout_.name));
  }
  rows_.push_back(std::move(row));
}

std::size_t Table::column(std::string_view name) const {
  for (std::size_t i = 0; i < layout_.columns.size(); ++i)
    if (layout_.columns[i].name == name) return i;
  throw InternalError(fmt::format("table {} has no column {}", layout_.name, name));
}

const std::string& Table::text(std::size_t row, std::string_view name) const {
  return rows_.at(row)[column(name)];
}

double Table::number(std::size_t row, std::string_view name) const {
  const std::string& value = text(row, name);
  return value.empty() ? std::numeric_limits<double>::quiet_NaN()
                       : std::strtod(value.c_str(), nullptr);
}

std::vector<double> Table::numbers(std::string_view name) const {
  std::vector<double> values;
  for (std::size_t row = 0; row < size(); ++row) values.push_back(number(row, name));
  return values;
}

std::string to_csv(const Table& table) {
  std::string out;
  const auto& columns = table.layout().columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) out += ',';
    append_field(out, columns[i].name);
  }
  out += '\n';
  for (const auto& row : table.rows()) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += ',';
      append_field(out, row[i]);
    }
    out += '\n';
  }
  return out;
}

}  // namespace tripus::studies
