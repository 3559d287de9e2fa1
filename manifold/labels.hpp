#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "topology/cone_angle.hpp"

namespace tripus {

/// Changes cone angles [E] by assignments "EDGE=VALUE". An empty list stands for 2 pi everywhere,
/// and stays empty if nothing is assigned.
class LabelAssignment {
 public:
  LabelAssignment(std::vector<topology::ConeAngle>& cone_angles, std::size_t edge_count)
      : cone_angles_(cone_angles), edge_count_(edge_count), assigned_(edge_count) {}

  /// Assigns "0=2,1=3". Throws InvalidInput, naming where it was typed (`place`), the assignment
  /// and the remedy: for a form other than `example`, an edge class that does not exist, a second
  /// label on one edge class, and what `parse` throws.
  void assign(std::string_view place, std::string_view list, std::string_view example,
              const std::function<topology::ConeAngle(std::string_view)>& parse);

 private:
  std::vector<topology::ConeAngle>& cone_angles_;
  std::size_t edge_count_;
  std::vector<bool> assigned_;
};

/// Cone angles [E] with those labels on top that stand behind an INPUT, "0=7,1=2"; as they are if
/// there are none. Throws InvalidInput as LabelAssignment.
std::vector<topology::ConeAngle> labelled(std::vector<topology::ConeAngle> cone_angles,
                                          std::size_t edge_count, const std::string& labels);

/// An INPUT and the labels behind it on a line of a batch: "eLAkbbcddpuchf 0=7,1=2" becomes
/// {"eLAkbbcddpuchf", "0=7,1=2"}; without labels, or if there is a file of the whole name, the
/// second is empty.
std::pair<std::string, std::string> split_labels(const std::string& input);

}  // namespace tripus
