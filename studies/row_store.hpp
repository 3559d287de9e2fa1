#pragma once

#include <cstdio>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace tripus::studies {

/// One row for one of the tables of a study.
struct Row {
  std::size_t table = 0;
  std::vector<std::string> cells;
};

/// The finished work items of a study, in an append-only file: a line an item, flushed when it is
/// done. A process may end at any moment, in the middle of a line too: opening the file again drops
/// a line that was not finished, and everything before it stands.
class RowStore {
 public:
  /// Opens or makes the file. `fingerprint` says what the items depend on; it is the first line.
  /// Throws InvalidInput if the file belongs to another fingerprint or cannot be opened.
  RowStore(std::string path, std::string fingerprint);
  ~RowStore();
  RowStore(const RowStore&) = delete;
  RowStore& operator=(const RowStore&) = delete;

  bool has(const std::string& id) const;
  std::size_t size() const;
  /// Keeps the rows of a finished item. Safe to call from several threads.
  /// Throws Error if they cannot be written.
  void add(const std::string& id, std::vector<Row> rows);
  /// The rows of an item that is there.
  const std::vector<Row>& rows(const std::string& id) const { return items_.at(id); }

 private:
  void read(const std::string& fingerprint);
  void write_line(const std::string& line);

  std::string path_;
  std::FILE* file_ = nullptr;
  mutable std::mutex mutex_;
  std::map<std::string, std::vector<Row>> items_;
};

}  // namespace tripus::studies
