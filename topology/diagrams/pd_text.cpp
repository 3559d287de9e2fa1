// Planar diagrams as text, KnotTheory's X[4,2,5,1] and all its relatives, and as JSON.
#include <algorithm>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology::detail {
namespace {

NodeKind kind_of(std::size_t arcs) { return arcs == 4 ? NodeKind::kCrossing : NodeKind::kVertex; }

class PdReader {
 public:
  explicit PdReader(std::string_view text) : scan_(text) {}

  NamedDiagram read() {
    bool clockwise = false;
    if (scan_.take_word("PD")) {
      const bool parenthesis = scan_.take('(') && Scanner::is_letter(scan_.peek());
      if (scan_.take_word("clockwise")) clockwise = true;
      if (scan_.take_word("counterclockwise")) clockwise = false;
      if (parenthesis) scan_.expect(')');
      scan_.take(':');
    }
    while (!scan_.at_end()) item();
    if (!open_.empty()) {
      const auto [bracket, at] = open_.back();
      scan_.fail(
          std::string("the bracket ") + bracket + " is not closed; add " + closing_of(bracket), at);
    }
    if (clockwise) turn_round(nodes_);
    result_.diagram = Diagram(nodes_);
    return std::move(result_);
  }

 private:
  // Brackets around nodes mean nothing but must close.
  void item() {
    const char c = scan_.peek();
    const std::size_t at = scan_.position();
    if (c == ',' || c == ';') {
      scan_.take_any();
    } else if (is_closing(c)) {
      if (open_.empty() || closing_of(open_.back().first) != c)
        scan_.fail(std::string("the bracket ") + c + " closes nothing that is open; take it away");
      open_.pop_back();
      scan_.take_any();
    } else if (is_opening(c)) {
      scan_.take_any();
      if (scan_.at_number())
        node("", c, at);
      else
        open_.emplace_back(c, at);
    } else {
      const std::string word(scan_.letters());
      if (scan_.peek_raw() == '_') scan_.take_any();
      if (word == "PD")
        scan_.fail(
            "a second diagram begins here; give one alone, or put one in a line and give the "
            "file to --batch",
            at);
      if (word.empty() || !is_opening(scan_.peek()))
        scan_.fail("expected a node such as X[4,2,5,1] or V[1,2,3]" + scan_.found(), at);
      const char bracket = scan_.peek();
      scan_.take_any();
      if (word == "Cone")
        label(bracket, at);
      else
        node(word, bracket, at);
    }
  }

  void node(const std::string& word, char bracket, std::size_t at) {
    DiagramNode node;
    if (!is_closing(scan_.peek())) node.arcs.push_back(scan_.integer());
    while (scan_.peek() != closing_of(bracket)) {
      if (scan_.at_end() || is_closing(scan_.peek()) || is_opening(scan_.peek()))
        scan_.fail(
            std::string("the bracket ") + bracket + " is not closed; add " + closing_of(bracket),
            at);
      scan_.take(',');
      node.arcs.push_back(scan_.integer());
    }
    scan_.take_any();
    if (word == "Loop" || word == "V" || word == "P" || word == "B")
      node.kind = NodeKind::kVertex;
    else if (word.empty())
      node.kind = kind_of(node.arcs.size());
    else if (word[0] != 'X')
      scan_.fail(quoted(word) + " is no kind of node; X is a crossing, V a vertex", at);
    if (word == "Loop" && node.arcs.size() == 1) node.arcs.push_back(node.arcs.front());
    node.place = to_text(node) + " (" + scan_.place(at) + ")";
    nodes_.push_back(std::move(node));
  }

  void label(char bracket, std::size_t at) {
    const std::int64_t arc = scan_.integer();
    scan_.expect(',');
    const std::string order(scan_.until("])}"));
    scan_.expect(closing_of(bracket));
    try {
      result_.labels.push_back({arc, parse_cone_order(order)});
    } catch (const InvalidInput& error) {
      scan_.fail("Cone of arc " + std::to_string(arc) + ": " + error.what(), at);
    }
  }

  Scanner scan_;
  std::vector<std::pair<char, std::size_t>> open_;
  std::vector<DiagramNode> nodes_;
  NamedDiagram result_;
};

using nlohmann::json;

std::string at_node(std::size_t n) {
  return "JSON: node " + std::to_string(n) + " of \"diagram\": ";
}

DiagramNode json_node(const json& entry, std::size_t n) {
  const bool with_kind = entry.is_array() && entry.size() == 2 && entry[0].is_string();
  const json& arcs = with_kind ? entry[1] : entry;
  if (!arcs.is_array() ||
      !std::ranges::all_of(arcs, [](const json& a) { return a.is_number_integer(); }))
    throw InvalidInput(at_node(n) +
                       "expected [\"X\", [4,2,5,1]], [\"V\", [1,2,3]] or a list of arcs");
  DiagramNode node;
  for (const json& arc : arcs) node.arcs.push_back(arc.get<std::int64_t>());
  node.kind = kind_of(node.arcs.size());
  if (with_kind) {
    const std::string kind = entry[0].get<std::string>();
    if (kind != "X" && kind != "V")
      throw InvalidInput(at_node(n) + quoted(kind) +
                         " is no kind of node; X is a crossing, V a vertex");
    node.kind = kind == "X" ? NodeKind::kCrossing : NodeKind::kVertex;
  }
  node.place = at_node(n) + to_text(node);
  return node;
}

void json_labels(const json& orders, NamedDiagram& result) {
  if (!orders.is_object())
    throw InvalidInput("JSON: \"cone_orders\" of a diagram is an object {\"arc\": order}");
  for (const auto& [arc, order] : orders.items()) {
    const auto name = parse_integer(arc);
    if (!name)
      throw InvalidInput("JSON: \"cone_orders\": " + quoted(arc) + " is not the number of an arc");
    try {
      result.labels.push_back(
          {*name, parse_cone_order(order.is_string() ? order.get<std::string>() : order.dump())});
    } catch (const InvalidInput& error) {
      throw InvalidInput("JSON: cone order of arc " + arc + ": " + error.what());
    }
  }
}

}  // namespace

NamedDiagram read_pd_text(std::string_view text) { return PdReader(text).read(); }

NamedDiagram read_diagram_json(std::string_view text) {
  json document;
  try {
    const auto stop_deep = [](int depth, json::parse_event_t, json&) {
      if (depth > 8) throw InvalidInput("JSON: a diagram is nested more than 8 levels deep");
      return true;
    };
    document = json::parse(text.begin(), text.end(), stop_deep);
  } catch (const json::exception& error) {
    throw InvalidInput("JSON: " + quoted(error.what(), 120));
  }
  const auto list = document.find("diagram");
  if (list == document.end() || !list->is_array())
    throw InvalidInput("JSON: \"diagram\" is no list of nodes [[\"X\", [4,2,5,1]], ...]");
  std::vector<DiagramNode> nodes;
  for (const json& entry : *list) nodes.push_back(json_node(entry, nodes.size()));
  if (document.value("clockwise", json(false)) == json(true)) turn_round(nodes);
  NamedDiagram result;
  if (const auto name = document.find("name"); name != document.end() && name->is_string())
    result.name = name->get<std::string>();
  if (const auto orders = document.find("cone_orders"); orders != document.end())
    json_labels(*orders, result);
  result.diagram = Diagram(nodes);
  return result;
}

}  // namespace tripus::topology::detail
