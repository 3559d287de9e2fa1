#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace tripus::studies {

enum class Mark { kLine, kPoint, kLineAndPoint, kBar };

/// Data of one kind. Colours and marker shapes are told apart without seeing hue: the Okabe-Ito
/// palette, with a marker and a dash pattern of its own for each colour.
struct Series {
  std::string label;  ///< for the legend; empty for none
  Mark mark = Mark::kLineAndPoint;
  std::vector<std::array<double, 2>> points;  ///< what an axis cannot show is left out
  std::vector<double> base;                   ///< bars: where each starts; empty for 0
  int colour = -1;                            ///< of the palette; -1: the number of the series
};

struct Axis {
  std::string label;  ///< with the unit
  bool log = false;
  double lower = std::numeric_limits<double>::quiet_NaN();  ///< NaN: from the data
  double upper = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> categories;  ///< if not empty, the value i stands for entry i
};

/// A dashed line across the plot.
struct Guide {
  bool vertical = true;
  double at = 0;
  std::string label;
};

struct Figure {
  std::string name;  ///< NAME.svg
  std::string title;
  std::string caption;  ///< what there is to see
  Axis x, y;
  std::vector<Series> series;
  std::vector<Guide> guides;
};

/// The figure as a self-contained SVG document.
std::string to_svg(const Figure& figure);

}  // namespace tripus::studies
