// Diagrams of knots and links from the walk along them.
#include <algorithm>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include "base/error.hpp"
#include "topology/diagrams/detail/forms.hpp"

// Each crossing becomes a wheel of four spokes, which has but one embedding and its mirror image.

namespace tripus::topology::detail {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                    boost::property<boost::vertex_index_t, std::size_t>,
                                    boost::property<boost::edge_index_t, std::size_t>>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;

}  // namespace

std::vector<bool> planar_choice(const Positions& p) {
  const std::size_t n = p.crossings.size();
  Graph graph(5 * n);  // the rims of each position, in and out, then the hubs
  std::size_t edges = 0;
  const auto join = [&](std::size_t a, std::size_t b) { add_edge(a, b, edges++, graph); };
  const auto in = [](std::size_t q) { return 2 * q; };
  const auto out = [](std::size_t q) { return 2 * q + 1; };
  for (std::size_t q = 0; q < 2 * n; ++q) join(out(q), in(p.following[q]));
  for (std::size_t c = 0; c < n; ++c) {
    const auto [first, second] = p.crossings[c];
    const std::size_t rim[4] = {in(first), in(second), out(first), out(second)};
    for (std::size_t k = 0; k < 4; ++k) {
      join(rim[k], rim[(k + 1) % 4]);
      join(4 * n + c, rim[k]);
    }
  }
  std::vector<std::vector<Edge>> rotation(num_vertices(graph));
  const bool planar =
      boost::boyer_myrvold_planarity_test(boost::boyer_myrvold_params::graph = graph,
                                          boost::boyer_myrvold_params::embedding = rotation.data());
  if (!planar) throw InvalidInput("no diagram in the plane has this code; look for a wrong entry");
  std::vector<bool> behind(n);
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t hub = 4 * n + c;
    std::vector<std::size_t> around;
    for (const Edge& e : rotation[hub])
      around.push_back(source(e, graph) == hub ? target(e, graph) : source(e, graph));
    const auto at = static_cast<std::size_t>(std::ranges::find(around, in(p.crossings[c].first)) -
                                             around.begin());
    behind[c] = around[(at + 1) % 4] == in(p.crossings[c].second);
  }
  return behind;
}

std::vector<DiagramNode> nodes_of(const Positions& p, const std::vector<bool>& behind) {
  std::vector<DiagramNode> nodes;
  for (std::size_t c = 0; c < behind.size(); ++c) {
    const auto [first, second] = p.crossings[c];
    const auto in = [](std::size_t q) { return static_cast<std::int64_t>(q + 1); };
    const auto out = [&](std::size_t q) { return in(p.following[q]); };
    // Counterclockwise: first in, second in, first out, second out; or the second ones exchanged.
    std::vector arcs{in(first), behind[c] ? in(second) : out(second), out(first),
                     behind[c] ? out(second) : in(second)};
    if (p.above[first]) {  // the second strand's beginning goes first
      const std::ptrdiff_t turn = behind[c] ? 1 : 3;
      std::rotate(arcs.begin(), arcs.begin() + turn, arcs.end());
    }
    nodes.push_back({NodeKind::kCrossing, arcs});
  }
  return nodes;
}

}  // namespace tripus::topology::detail
