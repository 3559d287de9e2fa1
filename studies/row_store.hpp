#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "base/journal.hpp"

namespace tripus::studies {

/// One row for one of the tables of a study.
struct Row {
  std::size_t table = 0;
  std::vector<std::string> cells;
};

/// The finished work items of a study, in an append-only file: a line an item, flushed when it is
/// done: a Journal, with all that it promises.
class RowStore {
 public:
  /// Opens or makes the file. `fingerprint` says what the items depend on; it is the first line.
  /// Throws what Journal throws.
  RowStore(const std::string& path, const std::string& fingerprint);

  bool has(const std::string& id) const;
  std::size_t size() const;
  /// Keeps the rows of a finished item. Safe to call from several threads.
  /// Throws IoError if they cannot be written.
  void add(const std::string& id, std::vector<Row> rows);
  /// The rows of an item that is there.
  const std::vector<Row>& rows(const std::string& id) const { return items_.at(id); }

 private:
  Journal journal_;
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<Row>> items_;
};

}  // namespace tripus::studies
