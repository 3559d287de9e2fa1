// appcontour's pictures of knots and graphs in letters: knot { ^ ^ ; ( x ); U U ; }.
#include <map>
#include <string>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

// The rows are read from above to below, each from left to right; what counts is which strand of
// the row above a letter takes up, not in which column it stands. Source: appcontour, knot2morse.c
// and README.

namespace tripus::topology::detail {
namespace {

/// What a letter takes from the row above and hands to the one below.
struct Letter {
  std::size_t takes, gives;
};
constexpr std::string_view kPlain = "|()/\\";

/// Null if there is no such letter.
const Letter* find_letter(char c) {
  static constexpr Letter kPass{1, 1}, kTop{0, 2}, kBottom{2, 0}, kCross{2, 2}, kJoin{2, 1},
      kFork{1, 2}, kStart{0, 1}, kEnd{1, 0};
  switch (c) {
    case '^':
      return &kTop;
    case 'U':
      return &kBottom;
    case 'X':
    case '%':
    case 'x':
      return &kCross;
    case 'Y':
    case 'y':
      return &kJoin;
    case 'h':
      return &kFork;
    case ',':
      return &kStart;
    case '\'':
      return &kEnd;
    default:
      return kPlain.find(c) == std::string_view::npos ? nullptr : &kPass;
  }
}

class PictureReader {
 public:
  explicit PictureReader(std::string_view text) : scan_(text) {}

  NamedDiagram read() {
    const std::string word(scan_.letters());
    if (word != "knot")
      throw InvalidInput(
          "it is the contour of a surface (appcontour's \"" + word +
          "\"), and no diagram; give the graph as knot { ... } or embedding { ... }");
    brackets_.open(scan_);
    while (scan_.peek() != '}') row();
    if (!above_.empty())
      scan_.fail("the picture ends with " + std::to_string(above_.size()) +
                 " open strands; close them by U, or ' for a free end");
    brackets_.close(scan_);
    if (!scan_.at_end()) scan_.fail("expected the end" + scan_.found());
    for (DiagramNode& node : nodes_)
      for (std::int64_t& arc : node.arcs) arc = end_of(arc);
    NamedDiagram result;
    result.diagram = Diagram(nodes_);
    return result;
  }

 private:
  using Ends = std::vector<std::int64_t>;

  void row() {
    const std::size_t at = scan_.position();
    std::size_t used = 0;
    Ends below;
    while (scan_.peek() != ';') {
      if (scan_.peek() == '}' || scan_.at_end()) scan_.fail("a row is not finished; end it by ;");
      const std::size_t here = scan_.position();
      const char c = scan_.take_any();
      const Letter* letter = find_letter(c);
      if (letter == nullptr)
        scan_.fail(
            quoted(std::string(1, c)) +
                " is no letter of a knot picture; there are ^ U X x Y y h , ' and | ( ) / \\",
            here);
      if (used + letter->takes > above_.size())
        scan_.fail(std::string(1, c) +
                       " takes up a strand that the row above does not have; it "
                       "hands down " +
                       std::to_string(above_.size()),
                   here);
      const Ends given = draw(c, above_.begin() + static_cast<std::ptrdiff_t>(used),
                              " (" + scan_.place(here) + ")");
      below.insert(below.end(), given.begin(), given.end());
      used += letter->takes;
    }
    if (used != above_.size())
      scan_.fail("this row takes up " + std::to_string(used) +
                     " strands, but the one above hands "
                     "down " +
                     std::to_string(above_.size()),
                 at);
    scan_.take(';');
    above_ = std::move(below);
  }

  // Counterclockwise at a node: upper right, upper left, lower left, lower right.
  Ends draw(char c, Ends::const_iterator upper, const std::string& place) {
    switch (c) {
      case '^':
        return {++names_, names_};
      case 'U':
        join(upper[0], upper[1]);
        return {};
      case 'x': {  // the strand from upper left to lower right passes above
        const Ends lower{++names_, ++names_};
        add(NodeKind::kCrossing, {upper[1], upper[0], lower[0], lower[1]}, c + place);
        return lower;
      }
      case 'X':
      case '%': {
        const Ends lower{++names_, ++names_};
        add(NodeKind::kCrossing, {upper[0], lower[0], lower[1], upper[1]}, c + place);
        return lower;
      }
      case 'Y':
      case 'y':
        add(NodeKind::kVertex, {upper[1], upper[0], ++names_}, c + place);
        return {names_};
      case 'h': {
        const Ends lower{++names_, ++names_};
        add(NodeKind::kVertex, {upper[0], lower[0], lower[1]}, c + place);
        return lower;
      }
      case ',':
        add(NodeKind::kVertex, {++names_}, c + place);
        return {names_};
      case '\'':
        add(NodeKind::kVertex, {upper[0]}, c + place);
        return {};
      default:
        return {upper[0]};
    }
  }

  void add(NodeKind kind, Ends arcs, std::string place) {
    nodes_.push_back({kind, std::move(arcs), std::move(place)});
  }

  /// Two names become one arc; if they are one already, it closes up to a circle without a node.
  void join(std::int64_t one, std::int64_t two) {
    one = end_of(one);
    two = end_of(two);
    if (one == two)
      nodes_.push_back({NodeKind::kVertex, {one, one}});
    else
      same_[one] = two;
  }
  std::int64_t end_of(std::int64_t name) const {
    for (auto next = same_.find(name); next != same_.end(); next = same_.find(name))
      name = next->second;
    return name;
  }

  DiagramScanner scan_;
  Brackets brackets_;
  Ends above_;  ///< the arcs that the rows so far hand down
  std::int64_t names_ = 0;
  std::map<std::int64_t, std::int64_t> same_;
  std::vector<DiagramNode> nodes_;
};

}  // namespace

NamedDiagram read_knot_picture(std::string_view text) { return PictureReader(text).read(); }

}  // namespace tripus::topology::detail
