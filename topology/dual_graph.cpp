#include "topology/dual_graph.hpp"

#include <utility>

#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/pending/queue.hpp>

namespace tripus::topology {
namespace {

// Arc 4 t + f leaves tetrahedron t through face f, so an arc's index tells its face; an open face
// becomes a loop, which a search ignores.
using DualGraph =
    boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                       boost::no_property, std::uint32_t, std::uint32_t>;

DualGraph dual_graph(const Gluings& gluings) {
  const auto count = static_cast<std::uint32_t>(gluings.tetrahedron_count());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
  arcs.reserve(4 * std::size_t{count});
  for (std::uint32_t t = 0; t < count; ++t)
    for (int f = 0; f < 4; ++f)
      arcs.emplace_back(t, gluings.is_open(t, f) ? t : gluings.neighbour(t, f));
  return {boost::edges_are_sorted, arcs.begin(), arcs.end(), count};
}

class ForestRecorder : public boost::default_bfs_visitor {
 public:
  explicit ForestRecorder(SpanningForest& forest) : forest_(forest) {}
  void discover_vertex(std::uint32_t t, const DualGraph&) { forest_.order.push_back(t); }
  template <class Arc>
  void tree_edge(const Arc& arc, const DualGraph& graph) {
    const auto child = boost::target(arc, graph);
    forest_.parent[child] = boost::source(arc, graph);
    forest_.face[child] = static_cast<std::uint8_t>(boost::get(boost::edge_index, graph, arc) % 4);
  }

 private:
  SpanningForest& forest_;
};

}  // namespace

SpanningForest spanning_forest(const Gluings& gluings) {
  const std::size_t count = gluings.tetrahedron_count();
  SpanningForest forest;
  forest.parent.assign(count, kNoTetrahedron);
  forest.face.assign(count, 0);
  forest.order.reserve(count);
  if (count == 0) return forest;
  const DualGraph graph = dual_graph(gluings);
  std::vector<boost::default_color_type> colours(count, boost::white_color);
  const auto colour_map =
      boost::make_iterator_property_map(colours.begin(), boost::get(boost::vertex_index, graph));
  for (std::uint32_t root = 0; root < count; ++root) {
    if (colours[root] != boost::white_color) continue;
    ++forest.component_count;
    boost::queue<std::uint32_t> queue;
    boost::breadth_first_visit(graph, root, queue, ForestRecorder(forest), colour_map);
  }
  return forest;
}

bool is_connected(const Gluings& gluings) { return spanning_forest(gluings).component_count == 1; }

}  // namespace tripus::topology
