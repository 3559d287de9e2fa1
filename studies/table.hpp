#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tripus::studies {

/// One documented column of a table. Timing columns depend on the machine; all others depend on
/// inputs, options and seed alone.
struct Column {
  std::string name;
  std::string unit;  ///< "radians", "seconds"; empty where there is none
  std::string description;
  bool timing = false;
};

struct TableLayout {
  std::string name;  ///< NAME.csv
  std::string description;
  std::vector<Column> columns;
};

/// A number with the digits that round-trip; empty for what is not finite.
std::string cell(double value);
inline std::string cell(std::string_view text) { return std::string(text); }
inline std::string cell(const char* text) { return text; }
inline std::string cell(bool value) { return value ? "yes" : "no"; }
template <std::integral Integer>
requires(!std::same_as<Integer, bool>) std::string cell(Integer value) {
  return std::to_string(value);
}

/// The cells of a row from values of any kind.
template <class... Values>
std::vector<std::string> cells(const Values&... values) {
  return {cell(values)...};
}

/// Tidy data: one observation a row.
class Table {
 public:
  explicit Table(TableLayout layout) : layout_(std::move(layout)) {}

  const TableLayout& layout() const { return layout_; }
  std::size_t size() const { return rows_.size(); }
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }

  /// Throws InternalError unless there is one cell a column.
  void add(std::vector<std::string> row);

  /// The number of a column. Throws InternalError if there is none of that name.
  std::size_t column(std::string_view name) const;
  const std::string& text(std::size_t row, std::string_view column) const;
  /// NaN for an empty cell.
  double number(std::size_t row, std::string_view column) const;
  std::vector<double> numbers(std::string_view column) const;
  bool is(std::size_t row, std::string_view column, std::string_view value) const {
    return text(row, column) == value;
  }

 private:
  TableLayout layout_;
  std::vector<std::vector<std::string>> rows_;
};

/// The table as CSV (RFC 4180, line ends "\n"), with a header line.
std::string to_csv(const Table& table);

}  // namespace tripus::studies
