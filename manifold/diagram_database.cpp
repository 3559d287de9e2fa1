// The tables of diagrams as a database.
#include <memory>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include "base/error.hpp"
#include "canonical/database_file.hpp"
#include "manifold/diagram_table.hpp"

namespace tripus {

void write_diagram_database(const std::vector<DiagramRow>& rows, const std::string& path) {
  const auto literal = [](const std::string& text) -> std::string {
    if (text.empty()) return "NULL";
    std::string sql = "'";
    for (const char c : text) sql += c == '\'' ? "''" : std::string(1, c);
    return sql + "'";
  };
  std::string sql =
      "BEGIN; CREATE TABLE diagram (name TEXT PRIMARY KEY, crossings INTEGER, boundary TEXT, "
      "homology TEXT, isosig TEXT, tetrahedra INTEGER, hyperbolic INTEGER, proved INTEGER, "
      "volume REAL, signature TEXT, oriented_signature TEXT, isometries INTEGER, "
      "reversing INTEGER, isometry_group TEXT, same_as TEXT);";
  for (const DiagramRow& row : rows)
    sql += fmt::format(
        "INSERT INTO diagram VALUES ({}, {}, {}, {}, {}, {}, {}, {:d}, {}, {}, {}, {}, {}, {}, "
        "{});",
        literal(row.name), row.crossings, literal(row.boundary), literal(row.homology),
        literal(row.isosig), row.tetrahedra,
        row.hyperbolic ? (*row.hyperbolic ? "1" : "0") : "NULL", row.proved,
        row.volume ? fmt::format("{}", *row.volume) : "NULL", literal(row.signature),
        literal(row.oriented_signature),
        row.isometries > 0 ? std::to_string(row.isometries) : "NULL",
        row.isometries > 0 ? std::to_string(row.reversing) : "NULL", literal(row.group),
        literal(fmt::format("{}", fmt::join(row.same_as, ","))));
  sql += "COMMIT;";
  sqlite3* handle = nullptr;
  int code = sqlite3_open(":memory:", &handle);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> closing(handle, sqlite3_close);
  if (code == SQLITE_OK) code = sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr);
  const std::string why = handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code);
  if (code != SQLITE_OK) throw InvalidInput(fmt::format("the database {}: {}", quoted(path), why));
  canonical::write_database_file(handle, path);
}

}  // namespace tripus
