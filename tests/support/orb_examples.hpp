#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/data_files.hpp"
#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::testing {

/// An example of Orb: the triangulation and its cone angles.
struct Labelled {
  topology::Triangulation triangulation;
  std::vector<topology::ConeAngle> cone_angles;
};

inline Labelled orb_example(const Row& row) {
  const auto faces = split(row.at("gluings"), ' ');
  topology::Gluings gluings(faces.size() / 4);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto parts = split(faces[i], ':');
    const std::string& p = parts.at(1);
    gluings.set_one_side(
        i / 4, static_cast<int>(i % 4),
        static_cast<topology::TetrahedronIndex>(std::stoul(parts[0])),
        topology::Perm4::from_images(p[0] - '0', p[1] - '0', p[2] - '0', p[3] - '0'));
  }
  Labelled example{topology::Triangulation(std::move(gluings)), {}};
  example.cone_angles.resize(example.triangulation.edge_count());
  if (row.at("labels") == "-") return example;
  for (const std::string& label : split(row.at("labels"), ' ')) {
    const auto sides = split(label, '=');
    const auto place = split(sides.at(0), ':');
    const int edge =
        topology::kEdgeNumber[std::size_t(place.at(1)[0] - '0')][std::size_t(place.at(1)[1] - '0')];
    example.cone_angles[example.triangulation.edge_class(std::stoul(place[0]), edge)] =
        topology::parse_cone_order(sides.at(1));
  }
  return example;
}

}  // namespace tripus::testing
