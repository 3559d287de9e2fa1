// Dowker-Thistlethwaite codes of knots and links.
#include <algorithm>
#include <cstdlib>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include "topology/diagrams/detail/forms.hpp"
#include "topology/diagrams/detail/scanner.hpp"

// Positions 1, 2, ... run along the components; crossing i has the odd position 2 i - 1 and the
// even one |code_i|, which passes above if the entry is negative. (All signs changed: the mirror
// image, which a code leaves open anyhow.) The code says which positions meet but not how the
// crossing lies in the plane: of the two ways to draw it, a planar embedding chooses. For that,
// each crossing becomes a wheel of four spokes, which has but one embedding and its mirror image.

namespace tripus::topology::detail {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                    boost::property<boost::vertex_index_t, std::size_t>,
                                    boost::property<boost::edge_index_t, std::size_t>>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;

struct Code {
  std::vector<std::vector<std::int64_t>> components;
};

/// SnapPy's letters: crossings, components, entries in each, then the entries, b = 4, B = -4.
Code from_letters(std::string_view letters, const Scanner& scan) {
  std::vector<std::int64_t> values;
  for (const char c : letters) values.push_back(c >= 'a' ? c - 'a' + 1 : -(c - 'A' + 1));
  std::size_t next = 2;
  Code code;
  const bool counts = values.size() >= 3 && values[0] > 0 && values[1] > 0;
  if (counts)
    for (std::int64_t k = 0; k < values[1] && next < values.size(); ++k)
      code.components.emplace_back(
          static_cast<std::size_t>(std::max<std::int64_t>(values[next++], 0)));
  for (auto& component : code.components)
    for (auto& entry : component)
      if (next < values.size()) entry = 2 * values[next++];
  std::size_t entries = 0;
  for (const auto& component : code.components) entries += component.size();
  if (!counts || entries != static_cast<std::size_t>(values[0]) ||
      values.size() != 2 + code.components.size() + entries)
    scan.fail(
        "the letters are no DT code: they count crossings, components and the entries of "
        "each, then give the entries, as in DT[cacbca] for the trefoil");
  return code;
}

Code parse(std::string_view text) {
  Scanner scan(text);
  scan.take_word("DT");
  scan.take(':');
  std::vector<std::pair<char, std::size_t>> open;
  Code code;
  bool fresh = true;
  while (!scan.at_end()) {
    const char c = scan.peek();
    if (is_opening(c)) {
      open.emplace_back(c, scan.position());
      fresh = true;
    } else if (is_closing(c)) {
      if (open.empty() || closing_of(open.back().first) != c)
        scan.fail(std::string("the bracket ") + c + " closes nothing that is open");
      open.pop_back();
      fresh = true;
    } else if (Scanner::is_letter(c)) {
      if (!code.components.empty()) scan.fail("letters and numbers are mixed");
      code = from_letters(scan.letters(), scan);
      if (scan.take('.')) (void)scan.until("])");
      continue;
    } else if (scan.at_number()) {
      if (fresh || code.components.empty()) code.components.emplace_back();
      fresh = false;
      code.components.back().push_back(scan.integer());
      continue;
    } else if (c != ',') {
      scan.fail("expected the even numbers of a DT code" + scan.found());
    }
    scan.take_any();
  }
  if (!open.empty())
    scan.fail(std::string("the bracket ") + open.back().first + " is not closed",
              open.back().second);
  return code;
}

/// The positions of a code: which meets which, and which follows.
struct Positions {
  std::vector<std::size_t> partner, following;  // [2n]
  std::vector<bool> above;                      // [2n]
};

Positions positions_of(const Code& code) {
  std::vector<std::int64_t> entries;
  Positions p;
  for (const auto& component : code.components) {
    const std::size_t first = p.following.size();
    for (std::size_t i = 0; i < 2 * component.size(); ++i) p.following.push_back(first + i + 1);
    if (!component.empty()) p.following.back() = first;
    entries.insert(entries.end(), component.begin(), component.end());
  }
  if (entries.empty()) throw InvalidInput("the DT code is empty; write DT: 4 6 8 2");
  p.partner.assign(2 * entries.size(), 2 * entries.size());
  p.above.assign(2 * entries.size(), false);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto even = static_cast<std::size_t>(std::abs(entries[i]));
    const std::string entry = "entry " + std::to_string(entries[i]) + " of the DT code";
    if (even % 2 != 0 || even == 0 || even > 2 * entries.size())
      throw InvalidInput(entry + ": expected the even numbers from 2 to " +
                         std::to_string(2 * entries.size()) + ", each once, with signs");
    if (p.partner[even - 1] != 2 * entries.size())
      throw InvalidInput(entry + " comes twice; each even number comes once");
    p.partner[even - 1] = 2 * i;
    p.partner[2 * i] = even - 1;
    p.above[entries[i] < 0 ? even - 1 : 2 * i] = true;
  }
  return p;
}

/// For each crossing (by its odd position, divided by two): whether the even strand enters
/// counterclockwise right behind the odd one.
std::vector<bool> embedded(const Positions& p) {
  const std::size_t n = p.partner.size() / 2;
  Graph graph(5 * n);  // the rims of each position, in and out, then the hubs
  std::size_t edges = 0;
  const auto join = [&](std::size_t a, std::size_t b) { add_edge(a, b, edges++, graph); };
  const auto in = [](std::size_t q) { return 2 * q; };
  const auto out = [](std::size_t q) { return 2 * q + 1; };
  for (std::size_t q = 0; q < 2 * n; ++q) join(out(q), in(p.following[q]));
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t odd = 2 * c, even = p.partner[odd], hub = 4 * n + c;
    for (const auto& [a, b] : {std::pair(in(odd), in(even)), std::pair(in(even), out(odd)),
                               std::pair(out(odd), out(even)), std::pair(out(even), in(odd))})
      join(a, b);
    for (const std::size_t rim : {in(odd), in(even), out(odd), out(even)}) join(hub, rim);
  }
  std::vector<std::vector<Edge>> rotation(num_vertices(graph));
  const bool planar =
      boost::boyer_myrvold_planarity_test(boost::boyer_myrvold_params::graph = graph,
                                          boost::boyer_myrvold_params::embedding = rotation.data());
  if (!planar)
    throw InvalidInput("no diagram in the plane has this DT code; look for a wrong entry");
  std::vector<bool> behind(n);
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t hub = 4 * n + c, odd = 2 * c;
    std::vector<std::size_t> around;
    for (const Edge& e : rotation[hub])
      around.push_back(source(e, graph) == hub ? target(e, graph) : source(e, graph));
    const auto at = static_cast<std::size_t>(std::ranges::find(around, in(odd)) - around.begin());
    behind[c] = around[(at + 1) % 4] == in(p.partner[odd]);
  }
  return behind;
}

}  // namespace

NamedDiagram read_dt_code(std::string_view text) {
  const Positions p = positions_of(parse(text));
  const std::vector<bool> behind = embedded(p);
  std::vector<DiagramNode> nodes;
  for (std::size_t c = 0; c < behind.size(); ++c) {
    const std::size_t odd = 2 * c, even = p.partner[odd];
    const auto in = [](std::size_t q) { return static_cast<std::int64_t>(q + 1); };
    const auto out = [&](std::size_t q) { return in(p.following[q]); };
    const bool odd_above = p.above[odd];
    // Counterclockwise: odd in, even in, odd out, even out; or with the even ones exchanged.
    std::vector arcs{in(odd), behind[c] ? in(even) : out(even), out(odd),
                     behind[c] ? out(even) : in(even)};
    if (odd_above) {  // the even strand's beginning goes first
      const std::size_t turn = behind[c] ? 1 : 3;
      std::rotate(arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(turn), arcs.end());
    }
    nodes.push_back({NodeKind::kCrossing, arcs});
  }
  NamedDiagram result;
  result.diagram = Diagram(nodes);
  result.orientation_known = false;
  result.notes.emplace_back(
      "a DT code leaves open which of two mirror images is meant; one was taken");
  return result;
}

}  // namespace tripus::topology::detail
