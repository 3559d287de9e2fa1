#include "studies/row_store.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace tripus::studies {
namespace {

using nlohmann::json;

std::string item_line(const std::string& id, const std::vector<Row>& rows) {
  json list = json::array();
  for (const Row& row : rows) list.push_back({row.table, row.cells});
  return json{{"item", id}, {"rows", list}}.dump();
}

/// Nothing where the line is not a finished item.
bool parse_item(const std::string& line, std::map<std::string, std::vector<Row>>& items) {
  const json item = json::parse(line, nullptr, false);
  if (!item.is_object() || !item.contains("item") || !item.contains("rows")) return false;
  std::vector<Row> rows;
  for (const json& row : item["rows"])
    rows.push_back({row.at(0).get<std::size_t>(), row.at(1).get<std::vector<std::string>>()});
  items[item["item"].get<std::string>()] = std::move(rows);
  return true;
}

}  // namespace

RowStore::RowStore(std::string path, std::string fingerprint) : path_(std::move(path)) {
  read(fingerprint);
  file_ = std::fopen(path_.c_str(), "ab");
  if (file_ == nullptr)
    throw InvalidInput("cannot write " + tripus::quoted(path_) + ": " + std::strerror(errno));
  if (std::filesystem::file_size(path_) == 0) write_line(json{{"study", fingerprint}}.dump());
}

RowStore::~RowStore() {
  if (file_ != nullptr) std::fclose(file_);
}

void RowStore::read(const std::string& fingerprint) {
  std::ifstream in(path_, std::ios::binary);
  if (!in) return;
  std::uintmax_t sound = 0;  // bytes of finished lines
  bool first = true;
  for (std::string line; std::getline(in, line) && !in.eof(); first = false) {
    if (first) {
      const json head = json::parse(line, nullptr, false);
      if (!head.is_object() || head.value("study", "") != fingerprint) {
        throw InvalidInput(tripus::quoted(path_) +
                           " holds another study, or one of other inputs or options; choose "
                           "another folder or delete it");
      }
    } else if (!parse_item(line, items_)) {
      break;
    }
    sound += line.size() + 1;
  }
  in.close();
  if (sound < std::filesystem::file_size(path_)) std::filesystem::resize_file(path_, sound);
}

void RowStore::write_line(const std::string& line) {
  const std::string text = line + '\n';
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0)
    throw Error("cannot write " + tripus::quoted(path_) + ": " + std::strerror(errno));
}

bool RowStore::has(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  return items_.contains(id);
}

std::size_t RowStore::size() const {
  const std::lock_guard lock(mutex_);
  return items_.size();
}

void RowStore::add(const std::string& id, std::vector<Row> rows) {
  const std::string line = item_line(id, rows);
  const std::lock_guard lock(mutex_);
  write_line(line);
  items_[id] = std::move(rows);
}

}  // namespace tripus::studies
