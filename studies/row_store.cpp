#include "studies/row_store.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace tripus::studies {
namespace {

using nlohmann::json;

std::string header_line(const std::string& fingerprint) {
  return json{{"study", fingerprint}}.dump();
}

std::string item_line(const std::string& id, const std::vector<Row>& rows) {
  json list = json::array();
  for (const Row& row : rows) list.push_back({row.table, row.cells});
  return json{{"item", id}, {"rows", list}}.dump();
}

/// False where the line is not a finished item.
bool parse_item(const std::string& line, std::map<std::string, std::vector<Row>>& items) {
  try {
    const json item = json::parse(line);
    std::vector<Row> rows;
    for (const json& row : item.at("rows"))
      rows.push_back({row.at(0).get<std::size_t>(), row.at(1).get<std::vector<std::string>>()});
    items[item.at("item").get<std::string>()] = std::move(rows);
    return true;
  } catch (const json::exception&) {
    return false;
  }
}

}  // namespace

RowStore::RowStore(const std::string& path, const std::string& fingerprint)
    : journal_(path, header_line(fingerprint)) {
  for (std::size_t k = 0; k < journal_.lines().size(); ++k)
    if (!parse_item(journal_.lines()[k], items_))
      throw InvalidInput(journal_.place(k) + " is not an item of a study");
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
  journal_.add(line);
  items_[id] = std::move(rows);
}

}  // namespace tripus::studies
