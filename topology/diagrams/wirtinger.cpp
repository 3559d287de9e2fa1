#include "topology/diagrams/wirtinger.hpp"

namespace tripus::topology {
namespace {

/// +1 if, seen along the under-strand, the over-strand runs from left to right: a positive
/// crossing.
int sign_of(const Diagram& diagram, const std::vector<bool>& outgoing, Dart under_in) {
  return outgoing[diagram.previous(under_in)] ? -1 : 1;
}

}  // namespace

// The over-strand of a crossing keeps its letter. The loop around the outgoing under-strand is
// the one around the incoming one, carried below the over-strand.
WirtingerGroup wirtinger_group(const Diagram& diagram) {
  WirtingerGroup group;
  group.strands = strands(diagram);
  group.of_dart.assign(diagram.dart_count(), 0);
  std::vector<bool> outgoing(diagram.dart_count(),
                             false);  // from its node, in the strand's direction
  Letter generators = 0;
  for (const Strand& strand : group.strands.all) {
    // A closed strand begins where it comes up, if it passes below anywhere.
    const std::size_t n = strand.darts.size();
    std::size_t start = 0;
    const auto comes_up = [&](std::size_t i) {
      const Dart d = strand.darts[i];
      return !diagram.is_at_crossing(d) || diagram.is_under(d);
    };
    while (start < n && !comes_up(start)) ++start;
    start %= n;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = (start + i) % n;
      const Dart d = strand.darts[at];
      if (i == 0 || comes_up(at)) ++generators;
      group.of_dart[d] = group.of_dart[diagram.mate(d)] = generators;
      outgoing[d] = true;
    }
  }
  group.presentation.generator_count = static_cast<std::size_t>(generators);
  const auto letter_over = [&](Dart under_in) {
    const int sign = sign_of(diagram, outgoing, under_in);
    return static_cast<Letter>(sign * group.of_dart[diagram.next(under_in)]);
  };
  for (std::size_t n = 0; n < diagram.node_count(); ++n) {
    Word relator;
    const Dart first = diagram.first_dart(n);
    if (diagram.is_crossing(n)) {
      const Dart in = outgoing[first] ? first + 2 : first;
      const Letter over = letter_over(in);
      relator = {over, group.of_dart[diagram.across(in)], -over, -group.of_dart[in]};
    } else {
      for (std::uint32_t k = 0; k < diagram.degree(n); ++k)
        relator.push_back(outgoing[first + k] ? group.of_dart[first + k]
                                              : -group.of_dart[first + k]);
    }
    group.presentation.relators.push_back(std::move(relator));
  }
  for (const Strand& strand : group.strands.all) {
    group.meridians.push_back({group.of_dart[strand.darts.front()]});
    Word longitude;
    std::int64_t turns = 0;
    for (const Dart d : strand.darts) {
      const Dart end = diagram.mate(d);
      if (!diagram.is_at_crossing(end) || !diagram.is_under(end)) continue;
      const Letter over = letter_over(end);
      longitude.push_back(over);
      if (group.strands.of_dart[diagram.next(end)] == group.strands.of_dart[end])
        turns += over > 0 ? 1 : -1;
    }
    // The longitude is read from the first dart on, so that it commutes with the meridian there.
    for (; strand.closed && turns > 0; --turns) longitude.push_back(-group.meridians.back()[0]);
    for (; strand.closed && turns < 0; ++turns) longitude.push_back(group.meridians.back()[0]);
    group.longitudes.push_back(std::move(longitude));
  }
  return group;
}

}  // namespace tripus::topology
