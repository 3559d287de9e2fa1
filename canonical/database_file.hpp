#pragma once

#include <string>

struct sqlite3;

namespace tripus::canonical {

/// Writes a SQLite database that was made in memory to a file, whole or not at all, as every other
/// file is. Throws what write_file throws, and std::bad_alloc.
void write_database_file(sqlite3* database, const std::string& path);

}  // namespace tripus::canonical
