#include "studies/figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "base/svg_text.hpp"

namespace tripus::studies {
namespace {

constexpr double kWidth = 780, kTop = 46, kRight = 26;
constexpr double kLetter = 6.7;  // mean width of a letter, 12 px
// Okabe and Ito's palette; black last, yellow left out: it is too pale on white.
constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                    "#E69F00", "#56B4E9", "#000000"};
constexpr int kColourCount = 7;
constexpr const char* kDashes[] = {"", "7 3", "2 2", "9 3 2 3", "4 2", "1 3", "12 4"};

const char* colour(int i) { return kColours[i % kColourCount]; }

/// An axis with its range settled.
struct Scale {
  bool log = false;
  double lower = 0, upper = 1;  // log10 of the values if log
  double from = 0, to = 1;      // pixels

  bool shows(double value) const {
    if (!std::isfinite(value) || (log && !(value > 0))) return false;
    const double v = log ? std::log10(value) : value;
    const double slack = 1e-9 * (upper - lower);
    return v >= lower - slack && v <= upper + slack;
  }
  double pixel(double value) const {
    const double v = log ? std::log10(value) : value;
    return from + (to - from) * (v - lower) / (upper - lower);
  }
};

void include(const Axis& axis, double value, double& lower, double& upper) {
  if (!std::isfinite(value) || (axis.log && !(value > 0))) return;
  lower = std::min(lower, value);
  upper = std::max(upper, value);
}

Scale make_scale(const Axis& axis, double lower, double upper) {
  if (!axis.categories.empty()) {
    lower = -0.5;
    upper = double(axis.categories.size()) - 0.5;
  } else {
    if (!(lower <= upper)) lower = upper = axis.log ? 1 : 0;
    if (axis.log) {
      lower = std::log10(lower), upper = std::log10(upper);
    }
    const double pad = upper > lower ? 0.04 * (upper - lower) : 0.5;
    lower -= pad, upper += pad;
    if (std::isfinite(axis.lower)) lower = axis.log ? std::log10(axis.lower) : axis.lower;
    if (std::isfinite(axis.upper)) upper = axis.log ? std::log10(axis.upper) : axis.upper;
  }
  return {axis.log, lower, upper, 0, 1};
}

struct Tick {
  double value;
  std::string label;
};

/// The smallest of 1, 2, 5 times a power of ten that is at least `step`.
double nice(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= step * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

std::vector<Tick> ticks(const Axis& axis, const Scale& scale, int wanted) {
  std::vector<Tick> result;
  for (std::size_t i = 0; i < axis.categories.size(); ++i)
    result.push_back({double(i), escaped_xml(axis.categories[i])});
  if (!result.empty()) return result;
  const double range = scale.upper - scale.lower;
  // A few decades of numbers that are read as they stand: 1, 2, 5, 10, ...
  if (scale.log && range >= 0.8 && range < 2.5 && scale.lower >= -3 && scale.upper <= 5) {
    for (double k = std::floor(scale.lower); k <= scale.upper; ++k) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double value = digit * std::pow(10.0, k);
        if (scale.shows(value)) result.push_back({value, fmt::format("{:.6g}", value)});
      }
    }
    return result;
  }
  if (scale.log && range >= 1.5) {
    const double step = std::max(1.0, nice(range / wanted));
    for (double k = std::ceil(scale.lower / step) * step; k <= scale.upper; k += step) {
      result.push_back(
          {std::pow(10.0, k),
           fmt::format("10<tspan dy=\"-6\" font-size=\"9\">{:.0f}</tspan>", k == 0 ? 0.0 : k)});
    }
    return result;
  }
  const double lower = scale.log ? std::pow(10.0, scale.lower) : scale.lower;
  const double upper = scale.log ? std::pow(10.0, scale.upper) : scale.upper;
  const double step = nice((upper - lower) / wanted);
  for (double k = std::ceil(lower / step); k * step <= upper * (1 + 1e-12); ++k)
    result.push_back({k * step, fmt::format("{:.6g}", k == 0 ? 0.0 : k * step)});
  return result;
}

std::string marker(int kind, double x, double y, const char* fill) {
  const double r = 3.4;
  switch (kind % 6) {
    case 1:
      return fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="6" height="6" fill="{}"/>)", x - 3,
                         y - 3, fill);
    case 2:
      return fmt::format(R"(<path d="M{:.1f} {:.1f}l4 7h-8z" fill="{}"/>)", x, y - 4, fill);
    case 3:
      return fmt::format(R"(<path d="M{:.1f} {:.1f}l4 4l-4 4l-4 -4z" fill="{}"/>)", x, y - 4, fill);
    case 4:
      return fmt::format(
          R"(<path d="M{:.1f} {:.1f}l6 6m0 -6l-6 6" stroke="{}" stroke-width="1.8"/>)", x - 3,
          y - 3, fill);
    case 5:
      return fmt::format(
          R"(<circle cx="{:.1f}" cy="{:.1f}" r="{}" fill="none" stroke="{}" stroke-width="1.6"/>)",
          x, y, r, fill);
    default:
      return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{}" fill="{}"/>)", x, y, r, fill);
  }
}

/// Everything that is drawn knows where the axes lie.
class Drawing {
 public:
  explicit Drawing(const Figure& figure) : figure_(figure) {
    place_axes();
    place_legend();
  }

  std::string draw() {
    out_ = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1:.0f}" width="{0}" height="{1:.0f}" )"
        R"(font-family="Helvetica, Arial, sans-serif" font-size="12" role="img">)"
        "\n<title>{2}</title>\n<desc>{3}</desc>\n"
        R"(<rect width="100%" height="100%" fill="white"/>)"
        "\n"
        R"(<text x="{4}" y="24" font-size="15" font-weight="bold">{2}</text>)"
        "\n",
        kWidth, height_, escaped_xml(figure_.title), escaped_xml(figure_.caption), 14);
    draw_axes();
    for (std::size_t i = 0; i < figure_.series.size(); ++i) draw_series(i);
    for (const Guide& guide : figure_.guides) draw_guide(guide);
    draw_legend();
    return out_ + "</svg>\n";
  }

 private:
  void place_axes() {
    double limits[4] = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (const Series& series : figure_.series) {
      const bool bars = series.mark == Mark::kBar;
      for (const auto& [x, y] : series.points) {
        include(figure_.x, bars ? x - 0.5 : x, limits[0], limits[1]);
        if (bars) include(figure_.x, x + 0.5, limits[0], limits[1]);
        include(figure_.y, y, limits[2], limits[3]);
      }
      for (const double y : series.base) include(figure_.y, y, limits[2], limits[3]);
      if (bars && series.base.empty()) include(figure_.y, 0, limits[2], limits[3]);
    }
    for (const Guide& guide : figure_.guides) {
      const int k = guide.vertical ? 0 : 2;
      include(guide.vertical ? figure_.x : figure_.y, guide.at, limits[k], limits[k + 1]);
    }
    x_ = make_scale(figure_.x, limits[0], limits[1]);
    y_ = make_scale(figure_.y, limits[2], limits[3]);
    double left = 78;
    for (const std::string& name : figure_.y.categories)
      left = std::max(left, 44 + kLetter * double(name.size()));
    x_.from = left, x_.to = kWidth - kRight;
    y_.from = kTop + std::max(360.0, 19.0 * double(figure_.y.categories.size()));
    y_.to = kTop;
  }

  void place_legend() {
    double x = x_.from, y = y_.from + 66;
    bool any = false;
    for (const Series& series : figure_.series) {
      const double width = 40 + kLetter * double(series.label.size());
      if (!series.label.empty() && x > x_.from && x + width > kWidth - 8) x = x_.from, y += 20;
      legend_.push_back({x, y});
      if (series.label.empty()) continue;
      x += width;
      any = true;
    }
    height_ = any ? y + 14 : y_.from + 54;
  }

  void line(double x1, double y1, double x2, double y2, const char* style) {
    out_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x1, y1, x2, y2, style);
  }

  void draw_axes() {
    const char* grid = R"(stroke="#dddddd" stroke-width="1")";
    for (const Tick& tick : ticks(figure_.x, x_, 9)) {
      const double x = x_.pixel(tick.value);
      line(x, y_.from, x, y_.to, grid);
      out_ += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle">{}</text>)"
                          "\n",
                          x, y_.from + 19, tick.label);
    }
    for (const Tick& tick : ticks(figure_.y, y_, 8)) {
      const double y = y_.pixel(tick.value);
      line(x_.from, y, x_.to, y, grid);
      out_ += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>)"
                          "\n",
                          x_.from - 8, y + 4, tick.label);
    }
    out_ += fmt::format(
        R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="none" stroke="#444444"/>)"
        "\n"
        R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" font-size="13">{}</text>)"
        "\n"
        R"svg(<text transform="translate(18 {:.1f}) rotate(-90)" text-anchor="middle" font-size="13">{}</text>)svg"
        "\n",
        x_.from, y_.to, x_.to - x_.from, y_.from - y_.to, (x_.from + x_.to) / 2, y_.from + 42,
        escaped_xml(figure_.x.label), (y_.from + y_.to) / 2, escaped_xml(figure_.y.label));
  }

  int colour_of(std::size_t i) const {
    return figure_.series[i].colour >= 0 ? figure_.series[i].colour : int(i);
  }

  void draw_series(std::size_t i) {
    const Series& series = figure_.series[i];
    const int which = colour_of(i);
    if (series.mark == Mark::kBar) return draw_bars(series, which);
    std::string path, markers;
    std::set<std::array<long, 2>> marked;  // thousands of marks on one spot show no more than one
    bool pen_down = false;
    for (const auto& [x, y] : series.points) {
      const bool shown = x_.shows(x) && y_.shows(y);
      if (shown) {
        path += fmt::format("{}{:.1f} {:.1f}", pen_down ? 'L' : 'M', x_.pixel(x), y_.pixel(y));
        if (marked.insert({std::lround(x_.pixel(x)), std::lround(y_.pixel(y))}).second)
          markers += marker(which, x_.pixel(x), y_.pixel(y), colour(which));
      }
      pen_down = shown;
    }
    if (series.mark != Mark::kPoint) {
      out_ += fmt::format(
          R"(<path d="{}" fill="none" stroke="{}" stroke-width="1.8" stroke-dasharray="{}"/>)"
          "\n",
          path, colour(which), kDashes[which % kColourCount]);
    }
    if (series.mark != Mark::kLine)
      out_ += fmt::format("<g fill-opacity=\"0.75\">{}</g>\n", markers);
  }

  void draw_bars(const Series& series, int which) {
    for (std::size_t k = 0; k < series.points.size(); ++k) {
      const auto [x, y] = series.points[k];
      const double base = series.base.empty() ? 0 : series.base[k];
      if (!(y > base)) continue;
      out_ += fmt::format(
          R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}" stroke="white" stroke-width="0.8"/>)"
          "\n",
          x_.pixel(x - 0.4), y_.pixel(y), x_.pixel(x + 0.4) - x_.pixel(x - 0.4),
          y_.pixel(base) - y_.pixel(y), colour(which));
    }
  }

  void draw_guide(const Guide& guide) {
    const char* style = R"(stroke="#444444" stroke-width="1.2" stroke-dasharray="5 4")";
    const Scale& scale = guide.vertical ? x_ : y_;
    if (!scale.shows(guide.at)) return;
    const double at = scale.pixel(guide.at);
    const bool flip = guide.vertical && at > (x_.from + x_.to) / 2;
    const double x = guide.vertical ? at + (flip ? -5 : 5) : x_.to - 6;
    const double y = guide.vertical ? y_.to + 15 + 15 * double(guides_++) : at - 5;
    if (guide.vertical)
      line(at, y_.from, at, y_.to, style);
    else
      line(x_.from, at, x_.to, at, style);
    out_ += fmt::format(
        R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}" paint-order="stroke" stroke="white" stroke-width="3">{}</text>)"
        "\n",
        x, y, flip || !guide.vertical ? "end" : "start", escaped_xml(guide.label));
  }

  void draw_legend() {
    for (std::size_t i = 0; i < figure_.series.size(); ++i) {
      const Series& series = figure_.series[i];
      if (series.label.empty()) continue;
      const auto [x, y] = legend_[i];
      const int which = colour_of(i);
      if (series.mark == Mark::kBar) {
        out_ += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="20" height="11" fill="{}"/>)", x,
                            y - 9, colour(which));
      } else {
        if (series.mark != Mark::kPoint) {
          out_ += fmt::format(
              R"(<path d="M{:.1f} {:.1f}h22" stroke="{}" stroke-width="1.8" stroke-dasharray="{}"/>)",
              x, y - 4, colour(which), kDashes[which % kColourCount]);
        }
        if (series.mark != Mark::kLine) out_ += marker(which, x + 11, y - 4, colour(which));
      }
      out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + 27, y,
                          escaped_xml(series.label));
    }
  }

  const Figure& figure_;
  Scale x_, y_;
  double height_ = 0;
  std::vector<std::array<double, 2>> legend_;
  int guides_ = 0;
  std::string out_;
};

}  // namespace

std::string to_svg(const Figure& figure) { return Drawing(figure).draw(); }

}  // namespace tripus::studies
