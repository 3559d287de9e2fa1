#include "canonical/database_file.hpp"

#include <memory>
#include <new>

#include <sqlite3.h>

#include "base/output_file.hpp"

namespace tripus::canonical {

void write_database_file(sqlite3* database, const std::string& path) {
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(
      sqlite3_serialize(database, "main", &size, 0), sqlite3_free);
  if (!bytes) throw std::bad_alloc();
  write_file(path, {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)});
}

}  // namespace tripus::canonical
