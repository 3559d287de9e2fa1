#include <charconv>
#include <new>

#include <fmt/format.h>
#include <sqlite3.h>

#include "base/error.hpp"
#include "base/version.hpp"
#include "canonical/census.hpp"
#include "canonical/database_file.hpp"
#include "canonical/detail/census_lines.hpp"

namespace tripus::canonical {
namespace {

constexpr const char* kSchema = R"sql(
BEGIN;
CREATE TABLE manifold (
  name TEXT PRIMARY KEY, tetrahedra INTEGER NOT NULL, boundary TEXT NOT NULL, volume REAL NOT NULL,
  homology TEXT NOT NULL, cells TEXT NOT NULL, keeping INTEGER NOT NULL,
  reversing INTEGER NOT NULL, signature TEXT NOT NULL UNIQUE);
CREATE TABLE triangulation (
  isosig TEXT PRIMARY KEY, manifold TEXT NOT NULL REFERENCES manifold (name));
CREATE TABLE unresolved (isosig TEXT PRIMARY KEY, surface TEXT);
CREATE VIEW hyperbolicity AS
  SELECT isosig, 'yes' AS hyperbolic, 'metric' AS because FROM triangulation UNION ALL
  SELECT isosig, CASE WHEN surface IS NULL THEN NULL ELSE 'no' END, surface FROM unresolved;
CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE INDEX manifold_by_volume ON manifold (volume);
CREATE INDEX triangulation_by_manifold ON triangulation (manifold);
)sql";

class Database {
 public:
  Database(const std::string& path, int flags) : path_(path) {
    check(sqlite3_open_v2(path.c_str(), &handle_, flags, nullptr));
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database() { sqlite3_close(handle_); }

  void run(const char* sql) { check(sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr)); }
  sqlite3* handle() { return handle_; }
  void check(int code) const {
    if (code == SQLITE_OK || code == SQLITE_ROW || code == SQLITE_DONE) return;
    const char* why = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
    const std::string text = fmt::format("the database {}: {}", tripus::quoted(path_), why);
    const int kind = code & 0xff;  // the rest says more about it
    if (kind == SQLITE_NOMEM) throw std::bad_alloc();
    if (kind == SQLITE_IOERR || kind == SQLITE_FULL) throw IoError(text);
    throw InvalidInput(text);
  }

 private:
  std::string path_;
  sqlite3* handle_ = nullptr;
};

class Statement {
 public:
  Statement(Database& database, const char* sql) : database_(database) {
    database.check(sqlite3_prepare_v2(database.handle(), sql, -1, &handle_, nullptr));
  }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement() { sqlite3_finalize(handle_); }

  Statement& bind(const std::string& text) {
    database_.check(sqlite3_bind_text(handle_, ++bound_, text.data(), static_cast<int>(text.size()),
                                      SQLITE_TRANSIENT));
    return *this;
  }
  Statement& bind(double value) {
    database_.check(sqlite3_bind_double(handle_, ++bound_, value));
    return *this;
  }
  Statement& bind(std::size_t value) {
    database_.check(sqlite3_bind_int64(handle_, ++bound_, static_cast<sqlite3_int64>(value)));
    return *this;
  }
  /// Inserts what was bound.
  void insert() {
    step();
    database_.check(sqlite3_reset(handle_));
    bound_ = 0;
  }
  /// Whether there is a row.
  bool step() {
    const int code = sqlite3_step(handle_);
    database_.check(code);
    return code == SQLITE_ROW;
  }
  std::string text(int column) const {
    const auto* bytes = sqlite3_column_text(handle_, column);
    return bytes == nullptr ? std::string() : reinterpret_cast<const char*>(bytes);
  }
  double number(int column) const { return sqlite3_column_double(handle_, column); }
  std::size_t count(int column) const {
    return static_cast<std::size_t>(sqlite3_column_int64(handle_, column));
  }

 private:
  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
  int bound_ = 0;
};

bool has_about(Database& database) {
  Statement table(database, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'about'");
  return table.step();
}

/// 0 if the database does not say that any are.
int proved_digits(Database& database, const std::string& path) {
  if (!has_about(database)) return 0;
  Statement about(database, "SELECT value FROM about WHERE key = 'proved digits of the volumes'");
  if (!about.step()) return 0;
  const std::string text = about.text(0);
  int digits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), digits);
  if (error != std::errc() || end != text.data() + text.size() || digits < 1 ||
      digits > detail::kMostProvedDigits)
    throw InvalidInput(
        fmt::format("the database {}: the proved digits of the volumes are {}, not 1 to {}",
                    tripus::quoted(path), quoted(text), detail::kMostProvedDigits));
  return digits;
}

void fill(Database& database, const Census& census) {
  Statement manifold(database, "INSERT INTO manifold VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement triangulation(database, "INSERT INTO triangulation VALUES (?, ?)");
  Statement unresolved(database, "INSERT INTO unresolved VALUES (?, nullif(?, ''))");
  for (const CensusEntry& e : census.manifolds) {
    manifold.bind(e.name).bind(e.tetrahedra).bind(e.boundary).bind(e.volume).bind(e.homology);
    manifold.bind(e.cells).bind(e.keeping).bind(e.reversing).bind(e.signature).insert();
    for (const std::string& isosig : e.triangulations)
      triangulation.bind(isosig).bind(e.name).insert();
  }
  for (const std::string& isosig : census.unresolved)
    unresolved.bind(isosig).bind(detail::surface_in(isosig)).insert();
  Statement about(database, "INSERT INTO about VALUES (?, ?)");
  about.bind("version").bind(std::string("tripus ") + kVersion).insert();
  if (census.proved_digits > 0)
    about.bind("proved digits of the volumes").bind(std::to_string(census.proved_digits)).insert();
  const auto lines = detail::census_lines(census, detail::VolumeDigits::kAll);
  about.bind("checksums").bind(detail::checksums_of(lines)).insert();
}

/// Databases of other programs, and of earlier versions, have no checksums.
void require_as_written(Database& database, const Census& census, const std::string& path) {
  if (!has_about(database)) return;
  Statement about(database, "SELECT value FROM about WHERE key = 'checksums'");
  const auto lines = detail::census_lines(census, detail::VolumeDigits::kAll);
  const auto damaged = about.step() ? detail::first_damaged(lines, about.text(0)) : lines.size();
  if (!damaged) return;
  throw InvalidInput(
      fmt::format("the database {} is damaged: {}", tripus::quoted(path),
                  *damaged < census.manifolds.size()
                      ? fmt::format("row {} of its manifolds, {}, is not as it was written",
                                    *damaged + 1, quoted(census.manifolds[*damaged].name))
                  : *damaged < lines.size()
                      ? fmt::format("its unresolved triangulation {} is not as it was written",
                                    quoted(census.unresolved[*damaged - census.manifolds.size()]))
                      : "it has not as many rows as were written"));
}

}  // namespace

void write_database(const Census& census, const std::string& path) {
  // Made in memory, so that the file comes to its name as every other does: whole, or not at all.
  Database database(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  database.run(kSchema);
  fill(database, census);
  database.run("COMMIT;");
  write_database_file(database.handle(), path);
}

Census read_database(const std::string& path) {
  Database database(path, SQLITE_OPEN_READONLY);
  Census census;
  Statement manifold(database,
                     "SELECT name, tetrahedra, boundary, volume, homology, cells, keeping, "
                     "reversing, signature FROM manifold ORDER BY rowid");
  Statement triangulation(database, "SELECT isosig, manifold FROM triangulation ORDER BY rowid");
  bool more = triangulation.step();
  while (manifold.step()) {
    CensusEntry e;
    e.name = manifold.text(0);
    e.tetrahedra = manifold.count(1);
    e.boundary = manifold.text(2);
    e.volume = manifold.number(3);
    e.homology = manifold.text(4);
    e.cells = manifold.text(5);
    e.keeping = manifold.count(6);
    e.reversing = manifold.count(7);
    e.signature = manifold.text(8);
    for (; more && triangulation.text(1) == e.name; more = triangulation.step())
      e.triangulations.push_back(triangulation.text(0));
    census.manifolds.push_back(std::move(e));
  }
  Statement unresolved(database, "SELECT isosig FROM unresolved ORDER BY rowid");
  while (unresolved.step()) census.unresolved.push_back(unresolved.text(0));
  census.proved_digits = proved_digits(database, path);
  require_as_written(database, census, path);
  return census;
}

}  // namespace tripus::canonical
