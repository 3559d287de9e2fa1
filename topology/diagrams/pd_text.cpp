// Planar diagrams as text: KnotTheory's X[4,2,5,1] and all its relatives.
#include <string>
#include <utility>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

namespace tripus::topology::detail {
namespace {

constexpr std::string_view kExpectedNode = "expected a node such as X[4,2,5,1] or V[1,2,3]";

class PdReader {
 public:
  explicit PdReader(std::string_view text) : scan_(text) {}

  NamedDiagram read() {
    while (heading()) {
    }
    while (!scan_.at_end()) item();
    brackets_.require_closed(scan_);
    if (clockwise_) turn_round(nodes_);
    result_.diagram = Diagram(nodes_);
    return std::move(result_);
  }

 private:
  /// "PD:", "PD clockwise:", "PD(clockwise) =". One may stand before another, as in "PD: PD[...]".
  bool heading() {
    if (!scan_.take_whole_word("PD")) return false;
    const std::size_t bracket = scan_.position();
    const bool parenthesis = scan_.take('(');
    const bool clockwise = scan_.take_whole_word("clockwise");
    bool said = clockwise || scan_.take_whole_word("counterclockwise") ||
                scan_.take_whole_word("anticlockwise");
    if (!said && scan_.take_whole_word("counter") && scan_.take('-'))
      said = scan_.take_whole_word("clockwise");
    if (said) clockwise_ = clockwise;
    if (parenthesis && !said) scan_.go_to(bracket);  // it is the list's
    if (parenthesis && said) scan_.expect(')');
    scan_.take(':');
    scan_.take('=');
    return true;
  }

  // Brackets around nodes mean nothing but must close.
  void item() {
    const char c = scan_.peek();
    const std::size_t at = scan_.position();
    if (c == ',' || c == ';') {
      scan_.take_any();
    } else if (is_closing(c)) {
      brackets_.close(scan_);
    } else if (is_opening(c)) {
      brackets_.open(scan_);
      if (scan_.at_number()) node("", false, at);
    } else {
      const std::string word(scan_.letters());
      const bool subscript = scan_.peek_raw() == '_';
      if (subscript) scan_.take_any();
      if (DiagramScanner::same_word(word, "PD"))
        scan_.fail(
            "a second diagram begins here; give one alone, or put one in a line and give the "
            "file to --batch",
            at);
      if (!word.empty() && is_digit(scan_.peek_raw())) return bare_node(word, at);
      if (word.empty() || !is_opening(scan_.peek()))
        scan_.fail(std::string(kExpectedNode) + scan_.found(), at);
      brackets_.open(scan_);
      if (DiagramScanner::same_word(word, "Cone"))
        label(at);
      else
        node(word, subscript, at);
    }
  }

  /// The arcs in a bracket that is open, and its end.
  void node(const std::string& word, bool subscript, std::size_t at) {
    DiagramNode node;
    while (!is_closing(scan_.peek())) {
      if (!node.arcs.empty()) scan_.take(',');
      if (scan_.at_end() || is_opening(scan_.peek()) || next_is_node()) brackets_.fail_open(scan_);
      if (is_closing(scan_.peek())) break;
      arc(node, word, subscript);
    }
    brackets_.close(scan_);
    add(std::move(node), word, at);
  }

  /// Whether a word with a bracket comes next.
  bool next_is_node() {
    const std::size_t at = scan_.position();
    const bool is_word = !scan_.letters().empty();
    const char behind = scan_.peek_raw();
    scan_.go_to(at);
    return is_word && (is_opening(behind) || behind == '_' || is_digit(behind));
  }

  /// X1425, X4,12,5,11: as the Knot Atlas shows them.
  void bare_node(const std::string& word, std::size_t at) {
    DiagramNode node;
    std::size_t end = 0;
    do {
      arc(node, word, true);
      end = scan_.position();
    } while (scan_.take(',') && scan_.at_number());
    scan_.go_to(end);
    add(std::move(node), word, at);
  }

  /// An arc, or (X_{1425}) several with one digit each.
  void arc(DiagramNode& node, const std::string& word, bool subscript) {
    const std::size_t at = scan_.position();
    const std::int64_t arc = scan_.integer();
    const std::string_view digits = trimmed(scan_.since(at));
    const bool alone = node.arcs.empty() && scan_.peek() != ',' && !scan_.at_number();
    const bool run =
        alone && (is_crossing(word) ? digits.size() == 4
                                    : subscript && is_vertex(word) && digits.size() > 1);
    if (!run || digits.find_first_not_of("0123456789") != std::string_view::npos)
      return node.arcs.push_back(arc);
    for (const char digit : digits) node.arcs.push_back(digit - '0');
  }

  void add(DiagramNode node, const std::string& word, std::size_t at) {
    const std::string_view written = scan_.since(at);
    const bool is_loop = DiagramScanner::same_word(word, "Loop");
    if (word.empty())
      node.kind = kind_of(node.arcs.size());
    else if (is_loop || is_vertex(word))
      node.kind = NodeKind::kVertex;
    else if (!is_crossing(word))
      scan_.fail(quoted(word) + " is no kind of node; X is a crossing, V a vertex", at);
    const bool plain = written.size() <= 60 && written.find_first_of("\n#") == written.npos;
    node.place = (plain ? std::string(written) : to_text(node)) + " (" + scan_.place(at) + ")";
    if (is_loop && node.arcs.size() != 1)
      throw InvalidInput(node.place + " has " + std::to_string(node.arcs.size()) +
                         " arcs; a circle is Loop[1], a vertex V[1,2,3]");
    if (is_loop) node.arcs.push_back(node.arcs.front());
    nodes_.push_back(std::move(node));
  }

  static bool is_crossing(std::string_view word) {
    for (const std::string_view each : {"X", "Xp", "Xm", "Xn"})
      if (DiagramScanner::same_word(word, each)) return true;
    return false;
  }
  static bool is_vertex(std::string_view word) {
    for (const std::string_view each : {"V", "P", "B"})
      if (DiagramScanner::same_word(word, each)) return true;
    return false;
  }

  void label(std::size_t at) {
    const std::int64_t arc = scan_.integer();
    if (!scan_.take(','))
      scan_.fail("expected a comma and a cone order, as in Cone[1,3]" + scan_.found());
    const std::string order(scan_.until("])}"));
    if (scan_.at_end()) brackets_.fail_open(scan_);
    brackets_.close(scan_);
    try {
      result_.labels.push_back({arc, parse_cone_order(order)});
    } catch (const InvalidInput& error) {
      scan_.fail("Cone of arc " + std::to_string(arc) + ": " + error.what(), at);
    }
  }

  DiagramScanner scan_;
  Brackets brackets_;
  bool clockwise_ = false;
  std::vector<DiagramNode> nodes_;
  NamedDiagram result_;
};

}  // namespace

NamedDiagram read_pd_text(std::string_view text) { return PdReader(text).read(); }

}  // namespace tripus::topology::detail
